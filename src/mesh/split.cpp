// Splitting an edge at its midpoint.
//
//  Face 1 keeps its slot as (b->m, m->a, a->b); m->c, c->a, a->m form the new face 3.
//  Face 2 keeps its slot as (m->b, b->d, d->m); c->m, m->d, d->c form the new face 4.
//
//           a                          a
//          / \                        /|\.
//         / 1 \         split        /1|3\.
//        b-----c      -------->     b--m--c
//         \ 2 /                      \2|4/
//          \ /                        \|/
//           d                          d
//
// Edge bm keeps the id of bc. New slots are allocated in this order: m; the left wedge at m (side
// of a), then the right one (side of d) unless the edge is smooth and the two sides share one; mc,
// am, dm; faces 3, 4; then for each sibling around the ring its wedge, mc, am and face 3. unsplit()
// releases them in the reverse order (invariant 12 of TriMesh).
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999, section 4 and figure 3.
#include <algorithm>
#include <atomic>
#include <cassert>

#include "mesh/midpoint_normal.h"
#include "mesh/tri_mesh.h"

namespace pectin {

std::uint16_t TriMesh::highest_level_around(EdgeId e) const {
    const HalfEdgeId bc = half_edge(e);
    std::uint16_t highest = std::max(level(origin(bc)), level(target(bc)));
    for_each_side(e, [&](HalfEdgeId h) { highest = std::max(highest, level(origin(prev(h)))); });
    return highest;
}

bool TriMesh::may_split(EdgeId e) const {
    return highest_level_ < kMaxLevel || highest_level_around(e) < kMaxLevel;
}

Split TriMesh::split(EdgeId e) {
    const Split s = insert_midpoint(e);
    set_position(s.m, 0.5 * position(s.b) + 0.5 * position(s.c));
    const auto write_normal = [this](const Split::Side& side, VertexId p, VertexId q, VertexId r) {
        const auto area_normal = [&] {
            return glm::cross(position(q) - position(p), position(r) - position(p));
        };
        set_normal(side.m, midpoint_normal(normal(side.b), normal(side.c), area_normal));
    };
    for_each_sheet(s, [&](const Split& sheet) {
        write_normal(sheet.left, sheet.b, sheet.c, sheet.a);
        if (sheet.right && sheet.right->m != sheet.left.m) {
            write_normal(*sheet.right, sheet.c, sheet.b, sheet.d);
        }
    });
    return s;
}

Split TriMesh::insert_midpoint(EdgeId e) {
    assert(is_live(e) && may_split(e));
    e = representative(e);
    reserve_for_split(e);
    const VertexId m = vertices_.allocate();
    describe_midpoint(e, m);
    const Split s = insert_into_sheet(e, m);
    vertices_.half_edges[index(m)] = half_edge(s.face3, 0);
    if (sibling(e) != e) insert_into_siblings(s);
    return s;
}

Split TriMesh::insert_midpoint(EdgeId e, const SplitIds& ids) {
    assert(is_live(e) && highest_level_around(e) < kMaxLevel && is_smooth(e));
    describe_midpoint(e, ids.m);
    Split s = before_split(e);
    s.m = ids.m;
    s.left.m = s.right->m = ids.wedge;
    s.mc = ids.mc;
    s.am = ids.am;
    s.dm = ids.dm;
    s.face3 = ids.face3;
    s.face4 = ids.face4;
    connect(s);
    vertices_.half_edges[index(ids.m)] = half_edge(ids.face3, 0);
    return s;
}

// Writes all attributes of m but its half-edge.
void TriMesh::describe_midpoint(EdgeId e, VertexId m) {
    const VertexId b = origin(half_edge(e)), c = target(half_edge(e));
    const auto level = static_cast<std::uint16_t>(highest_level_around(e) + 1);
    record_level(level);
    vertices_.levels[index(m)] = level;
    set_position(m, Vec3{0.0});
    set_deformed(m, is_deformed(b) || is_deformed(c));
    if (has_colors()) vertices_.colors[index(m)] = 0.5f * color(b) + 0.5f * color(c);
}

// Raises the upper bound of all levels. Safe to call concurrently.
void TriMesh::record_level(std::uint16_t level) {
    const std::atomic_ref highest(highest_level_);
    std::uint16_t known = highest.load(std::memory_order_relaxed);
    while (known < level && !highest.compare_exchange_weak(known, level)) {
    }
}

Split TriMesh::insert_into_sheet(EdgeId e, VertexId m) {
    Split s = before_split(e);
    s.m = m;
    s.left.m = wedges_.allocate();
    if (s.right) s.right->m = s.is_smooth() ? s.left.m : wedges_.allocate();
    s.mc = edges_.allocate();
    s.am = edges_.allocate();
    if (s.right) s.dm = edges_.allocate();
    s.face3 = faces_.allocate();
    if (s.right) s.face4 = faces_.allocate();
    connect(s);
    return s;
}

// The stencil of e before the split, in the sheet of e's half-edge. New elements are still none.
Split TriMesh::before_split(EdgeId e) const {
    const HalfEdgeId bc = half_edge(e);
    const HalfEdge &b = half_edge(bc), &c = half_edge(next(bc));
    Split s;
    s.a = origin(prev(bc));
    s.b = b.origin;
    s.c = c.origin;
    s.bm = e;
    s.left = {kNone<WedgeId>, b.wedge, c.wedge};
    if (!exists(b.twin)) return s;
    s.d = origin(prev(b.twin));
    s.right = Split::Side{kNone<WedgeId>, wedge(next(b.twin)), wedge(b.twin)};
    return s;
}

// Writes all new slots except that of m.
void TriMesh::connect(const Split& s) {
    const HalfEdgeId bc = half_edge(s.bm);
    faces_.bases[index(s.face3)] = base_face(face(bc));
    if (s.right) faces_.bases[index(s.face4)] = base_face(face(twin(bc)));
    if (tracks_errors()) {
        set_error(s.face3, error(face(bc)));
        if (s.right) set_error(s.face4, error(face(twin(bc))));
    }
    describe_edge(s.mc, level(s.bm));
    describe_edge(s.am, level(s.m));
    describe_wedge(s.left);
    connect_left(s);
    if (!s.right) return;
    describe_edge(s.dm, level(s.m));
    if (s.right->m != s.left.m) describe_wedge(*s.right);
    connect_right(s);
}

void TriMesh::describe_edge(EdgeId e, std::uint16_t level) {
    edges_.levels[index(e)] = level;
    if (!edges_.siblings.empty()) edges_.siblings[index(e)] = e;
}

void TriMesh::describe_wedge(const Split::Side& side) {
    set_normal(side.m, Vec3f{0.0f});
    if (has_uvs()) wedges_.uvs[index(side.m)] = 0.5f * uv(side.b) + 0.5f * uv(side.c);
}

//      a              a
//     / \            /|\.
//    / 1 \   --->   /1|3\.
//   b-----c        b--m--c
void TriMesh::connect_left(const Split& s) {
    auto& half_edges = faces_.half_edges;
    const HalfEdgeId bc = half_edge(s.bm), ca = next(bc), ab = prev(bc);
    const HalfEdgeId mc = half_edge(s.face3, 0), am = half_edge(s.face3, 2);
    const HalfEdgeId ma = ca;  // reuses the slot in face 1 that c->a leaves
    move_half_edge(ca, half_edge(s.face3, 1));
    half_edges[index(ma)] = {s.m, am, s.left.m, s.am};
    half_edges[index(am)] = {s.a, ma, wedge(ab), s.am};
    half_edges[index(mc)] = {s.m, kNone<HalfEdgeId>, s.left.m, s.mc};
    edges_.half_edges[index(s.mc)] = mc;
    edges_.half_edges[index(s.am)] = ma;
}

//   b-----c        b--m--c
//    \ 2 /   --->   \2|4/
//     \ /            \|/
//      d              d
void TriMesh::connect_right(const Split& s) {
    auto& half_edges = faces_.half_edges;
    const HalfEdgeId bc = half_edge(s.bm), cb = twin(bc), dc = prev(cb);
    const HalfEdgeId cm = half_edge(s.face4, 0), md = half_edge(s.face4, 1);
    const HalfEdgeId mb = cb, dm = dc;  // reuse the slots in face 2 that c->b and d->c leave
    const WedgeId wedge_d = wedge(dc);
    move_half_edge(cb, cm);
    move_half_edge(dc, half_edge(s.face4, 2));
    half_edges[index(cm)].edge = s.mc;
    half_edges[index(mb)] = {s.m, bc, s.right->m, s.bm};
    half_edges[index(dm)] = {s.d, md, wedge_d, s.dm};
    half_edges[index(md)] = {s.m, dm, s.right->m, s.dm};
    edges_.half_edges[index(s.dm)] = dm;
    link(bc, mb);
    link(half_edge(s.mc), cm);
}

}  // namespace pectin

// Splitting an edge at its midpoint.
// Source: Gain & Dodgson 1999, section 4, figure 3.
#include <algorithm>
#include <cassert>
#include <limits>

#include "mesh/midpoint_normal.h"
#include "mesh/tri_mesh.h"

namespace pectin {
namespace {

constexpr std::size_t kMostCounted = std::numeric_limits<std::uint32_t>::max();

}  // namespace

VertexId TriMesh::allocate_vertex() {
    if (!free_vertices_.empty()) {
        const VertexId v = free_vertices_.back();
        free_vertices_.pop_back();
        return v;
    }
    positions_.push_back(Vec3{0.0});
    vertex_half_edges_.push_back(kNone<HalfEdgeId>);
    vertex_levels_.push_back(0);
    deformed_.push_back(0);
    if (has_colors()) colors_.push_back(Vec3f{0.0f});
    return VertexId{vertex_slots() - 1};
}

WedgeId TriMesh::allocate_wedge() {
    if (!free_wedges_.empty()) {
        const WedgeId w = free_wedges_.back();
        free_wedges_.pop_back();
        return w;
    }
    normals_.push_back(Vec3f{0.0f});
    if (has_uvs()) uvs_.push_back(Vec2f{0.0f});
    return WedgeId{wedge_slots() - 1};
}

EdgeId TriMesh::allocate_edge() {
    if (!free_edges_.empty()) {
        const EdgeId e = free_edges_.back();
        free_edges_.pop_back();
        return e;
    }
    edge_half_edges_.push_back(kNone<HalfEdgeId>);
    edge_levels_.push_back(0);
    const EdgeId e{edge_slots() - 1};
    if (!siblings_.empty()) siblings_.push_back(e);
    return e;
}

FaceId TriMesh::allocate_face(FaceId base) {
    FaceId f;
    if (!free_faces_.empty()) {
        f = free_faces_.back();
        free_faces_.pop_back();
    } else {
        for (int corner = 0; corner < 3; ++corner) half_edges_.push_back(HalfEdge{});
        face_bases_.push_back(kNone<FaceId>);
        f = FaceId{face_slots() - 1};
    }
    face_bases_[index(f)] = base;
    return f;
}

EdgeId TriMesh::leader(EdgeId e) const {
    EdgeId lowest = e;
    for (EdgeId s = sibling(e); s != e; s = sibling(s)) lowest = std::min(lowest, s);
    return lowest;
}

std::uint16_t TriMesh::highest_level_round(EdgeId e) const {
    const HalfEdgeId bc = half_edge(e);
    std::uint16_t highest = std::max(level(origin(bc)), level(target(bc)));
    for_each_side(e, [&](HalfEdgeId h) { highest = std::max(highest, level(origin(prev(h)))); });
    return highest;
}

bool TriMesh::may_split(EdgeId e) const {
    return highest_level_round(e) < std::numeric_limits<std::uint16_t>::max();
}

Split TriMesh::split(EdgeId e) {
    const Split s = insert_midpoint(e);
    positions_[index(s.m)] = 0.5 * position(s.b) + 0.5 * position(s.c);
    const auto set_normal = [this](WedgeId m, HalfEdgeId from_b, HalfEdgeId from_c, VertexId apex) {
        const auto area_normal = [&] {
            const Vec3& b = position(origin(from_b));
            return glm::cross(position(origin(from_c)) - b, position(apex) - b);
        };
        normals_[index(m)] =
            midpoint_normal(normal(wedge(from_b)), normal(wedge(from_c)), area_normal);
    };
    for_each_sheet(star_of(s), [&](const Star& star) {
        set_normal(wedge(star.mc), star.bm, next(star.mc), star.a);
        if (star.on_boundary() || wedge(star.mb) == wedge(star.mc)) return;
        set_normal(wedge(star.mb), star.cm, next(star.mb), star.d);
    });
    return s;
}

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
//  Allocation order: m; its wedges; mc, am, dm; faces 3, 4; along a cut wedge, mc, am and face 3
//  of each sibling round the ring. unsplit releases in reverse.
Split TriMesh::insert_midpoint(EdgeId e) {
    assert(is_live(e) && may_split(e));
    e = leader(e);
    make_room(e);
    const VertexId m = allocate_vertex();
    vertex_levels_[index(m)] = static_cast<std::uint16_t>(highest_level_round(e) + 1);
    const Split s = insert_into_sheet(e, m);
    vertex_half_edges_[index(m)] = half_edge(s.face3, 0);
    deformed_[index(m)] = is_deformed(s.b) || is_deformed(s.c) ? 1 : 0;
    if (has_colors()) colors_[index(m)] = 0.5f * color(s.b) + 0.5f * color(s.c);
    if (sibling(e) != e) insert_into_siblings(s);
    return s;
}

// For the most a split adds, before it changes anything: without the memory nothing has happened.
void TriMesh::make_room(EdgeId e) {
    const bool along_cut = sibling(e) != e;
    if (!along_cut && room_.splits > 0) {
        --room_.splits;
        return;
    }
    std::size_t sides = 0;
    for_each_side(e, [&](HalfEdgeId) { ++sides; });
    reserve_for(std::max<std::size_t>(sides, 2));
    room_.splits = along_cut ? 0 : room_.splits - 1;
}

// Room for at least a split with so many sides, and notes how many with two there are then.
void TriMesh::reserve_for(std::size_t sides) {
    std::size_t splits = kMostCounted;
    const auto room = [&](auto& slots, std::size_t a_side) {
        const std::size_t added = a_side * sides;
        if (slots.capacity() - slots.size() < added) slots.reserve(2 * slots.size() + added);
        splits = std::min(splits, (slots.capacity() - slots.size()) / (2 * a_side));
    };
    room(positions_, 1);
    room(vertex_half_edges_, 1);
    room(vertex_levels_, 1);
    room(deformed_, 1);
    if (has_colors()) room(colors_, 1);
    room(normals_, 1);
    if (has_uvs()) room(uvs_, 1);
    room(edge_half_edges_, 2);
    room(edge_levels_, 2);
    if (!siblings_.empty()) room(siblings_, 2);
    room(half_edges_, 3);
    room(face_bases_, 1);
    room_.splits = static_cast<std::uint32_t>(splits);
}

Star TriMesh::star_of(const Split& s) const {
    Star star{.m = s.m, .a = s.a, .b = s.b, .c = s.c, .d = s.d};
    star.mc = half_edge(s.face3, 0);
    star.bm = half_edge(s.bm);
    if (s.right) {
        star.mb = twin(star.bm);
        star.cm = half_edge(s.face4, 0);
    }
    return star;
}

Split TriMesh::insert_into_sheet(EdgeId e, VertexId m) {
    const Split s = allocate_sheet(e, m);
    connect_left(s);
    if (s.right) connect_right(s);
    const auto interpolate_uv = [this](const Split::Side& side) {
        uvs_[index(side.m)] = 0.5f * uv(side.b) + 0.5f * uv(side.c);
    };
    if (has_uvs()) {
        interpolate_uv(s.left);
        if (s.right && s.right->m != s.left.m) interpolate_uv(*s.right);
    }
    return s;
}

// The siblings of the edge that `leader` has split, about the same m. Along bm and along mc the
// pieces become siblings, in the order that the edges had.
//
//      a1 a2             a1 a2
//      | / |             |\./|
//      b===c   ---->     b=m=c     here sheets 1 and 2 run the same way; where one runs from c to
//                                  b, its own bm lies along the others' mc
void TriMesh::insert_into_siblings(const Split& leader) {
    EdgeId along_bm = leader.bm, along_mc = leader.mc;
    const auto follow = [this](EdgeId& last, EdgeId e) {
        siblings_[index(last)] = e;
        last = e;
    };
    for (EdgeId e = sibling(leader.bm), next = e; e != leader.bm; e = next) {
        next = sibling(e);
        const Split s = insert_into_sheet(e, leader.m);
        const bool same_way = s.b == leader.b;
        follow(along_bm, same_way ? s.bm : s.mc);
        follow(along_mc, same_way ? s.mc : s.bm);
    }
    follow(along_bm, leader.bm);
    follow(along_mc, leader.mc);
}

Split TriMesh::allocate_sheet(EdgeId e, VertexId m) {
    const HalfEdgeId bc = half_edge(e), ca = next(bc), cb = twin(bc);
    Split s;
    s.m = m;
    s.b = origin(bc);
    s.c = origin(ca);
    s.a = origin(prev(bc));
    s.bm = e;
    s.left.b = wedge(bc);
    s.left.c = wedge(ca);
    if (exists(cb)) {
        s.d = origin(prev(cb));
        s.right = Split::Side{kNone<WedgeId>, wedge(next(cb)), wedge(cb)};
    }

    s.left.m = allocate_wedge();
    if (s.right) {
        const bool smooth = s.right->b == s.left.b && s.right->c == s.left.c;
        s.right->m = smooth ? s.left.m : allocate_wedge();
    }
    s.mc = allocate_edge();
    s.am = allocate_edge();
    if (s.right) s.dm = allocate_edge();
    s.face3 = allocate_face(face_bases_[index(face(bc))]);
    if (s.right) s.face4 = allocate_face(face_bases_[index(face(cb))]);

    edge_levels_[index(s.mc)] = level(e);
    edge_levels_[index(s.am)] = level(m);
    if (s.right) edge_levels_[index(s.dm)] = level(m);
    return s;
}

void TriMesh::connect_left(const Split& s) {
    const HalfEdgeId bc = half_edge(s.bm), ca = next(bc), ab = prev(bc);
    const HalfEdgeId mc = half_edge(s.face3, 0), am = half_edge(s.face3, 2);
    const HalfEdgeId ma = ca;  // its slot in face 1, after c->a has moved out
    move_half_edge(ca, half_edge(s.face3, 1));
    half_edges_[index(ma)] = {s.m, am, s.left.m, s.am};
    half_edges_[index(am)] = {s.a, ma, wedge(ab), s.am};
    half_edges_[index(mc)] = {s.m, kNone<HalfEdgeId>, s.left.m, s.mc};
    edge_half_edges_[index(s.mc)] = mc;
    edge_half_edges_[index(s.am)] = ma;
}

void TriMesh::connect_right(const Split& s) {
    const HalfEdgeId bc = half_edge(s.bm), cb = twin(bc), dc = prev(cb);
    const HalfEdgeId cm = half_edge(s.face4, 0), md = half_edge(s.face4, 1);
    const HalfEdgeId mb = cb, dm = dc;  // their slots in face 2, after c->b and d->c moved out
    const WedgeId wedge_d = wedge(dc);
    move_half_edge(cb, cm);
    move_half_edge(dc, half_edge(s.face4, 2));
    half_edges_[index(cm)].edge = s.mc;
    half_edges_[index(mb)] = {s.m, bc, s.right->m, s.bm};
    half_edges_[index(dm)] = {s.d, md, wedge_d, s.dm};
    half_edges_[index(md)] = {s.m, dm, s.right->m, s.dm};
    edge_half_edges_[index(s.dm)] = dm;
    link(bc, mb);
    link(half_edge(s.mc), cm);
}

}  // namespace pectin

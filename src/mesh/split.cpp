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
constexpr std::uint16_t kMostLevel = std::numeric_limits<std::uint16_t>::max();

}  // namespace

// The slot freed last, else a new one, for which make_room has made room.
VertexId TriMesh::allocate_vertex() {
    if (!free_vertices_.empty()) return free_vertices_.take_back();
    positions_.push_into_room(Vec3{0.0});
    vertex_half_edges_.push_into_room(kNone<HalfEdgeId>);
    vertex_levels_.push_into_room(0);
    deformed_.push_into_room(0);
    if (has_colors()) colors_.push_into_room(Vec3f{0.0f});
    return VertexId{vertex_slots() - 1};
}

WedgeId TriMesh::allocate_wedge() {
    if (!free_wedges_.empty()) return free_wedges_.take_back();
    normals_.push_into_room(Vec3f{0.0f});
    if (has_uvs()) uvs_.push_into_room(Vec2f{0.0f});
    return WedgeId{wedge_slots() - 1};
}

EdgeId TriMesh::allocate_edge(std::uint16_t level) {
    EdgeId e{edge_slots()};
    if (!free_edges_.empty()) {
        e = free_edges_.take_back();
        edge_levels_[index(e)] = level;
        return e;
    }
    edge_half_edges_.push_into_room(kNone<HalfEdgeId>);
    edge_levels_.push_into_room(level);
    if (!siblings_.empty()) siblings_.push_into_room(e);
    return e;
}

// Its half-edges are the caller's to write.
FaceId TriMesh::allocate_face(FaceId base) {
    FaceId f{face_slots()};
    if (!free_faces_.empty()) {
        f = free_faces_.take_back();
        face_bases_[index(f)] = base;
        return f;
    }
    half_edges_.grow_into_room(3);
    face_bases_.push_into_room(base);
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
    return highest_level_ < kMostLevel || highest_level_round(e) < kMostLevel;
}

Split TriMesh::split(EdgeId e) {
    const Split s = insert_midpoint(e);
    positions_[index(s.m)] = 0.5 * position(s.b) + 0.5 * position(s.c);
    const auto set_normal = [this](const Split::Side& side, VertexId p, VertexId q, VertexId r) {
        const auto area_normal = [&] {
            return glm::cross(position(q) - position(p), position(r) - position(p));
        };
        normals_[index(side.m)] = midpoint_normal(normal(side.b), normal(side.c), area_normal);
    };
    for_each_sheet(s, [&](const Split& sheet) {
        set_normal(sheet.left, sheet.b, sheet.c, sheet.a);
        if (sheet.right && sheet.right->m != sheet.left.m) {
            set_normal(*sheet.right, sheet.c, sheet.b, sheet.d);
        }
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
    const auto level = static_cast<std::uint16_t>(highest_level_round(e) + 1);
    highest_level_ = std::max(highest_level_, level);
    vertex_levels_[index(m)] = level;
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

// visit(array, elements that a side of a split adds to it at most).
template <typename Visit>
void TriMesh::for_each_array_of_splits(Visit visit) {
    visit(positions_, 1);
    visit(vertex_half_edges_, 1);
    visit(vertex_levels_, 1);
    visit(deformed_, 1);
    if (has_colors()) visit(colors_, 1);
    visit(normals_, 1);
    if (has_uvs()) visit(uvs_, 1);
    visit(edge_half_edges_, 2);
    visit(edge_levels_, 2);
    if (!siblings_.empty()) visit(siblings_, 2);
    visit(half_edges_, 3);
    visit(face_bases_, 1);
}

// Room for at least a split with so many sides, and notes how many with two there are then.
void TriMesh::reserve_for(std::size_t sides) {
    std::size_t splits = kMostCounted;
    for_each_array_of_splits([&](auto& slots, std::size_t a_side) {
        const std::size_t added = a_side * sides;
        if (slots.capacity() - slots.size() < added) slots.reserve(2 * slots.size() + added);
        splits = std::min(splits, (slots.capacity() - slots.size()) / (2 * a_side));
    });
    room_.splits = static_cast<std::uint32_t>(splits);
}

void TriMesh::reserve_splits(std::uint32_t count) {
    if (room_.splits < count) reserve_for(2 * std::size_t{count});
}

void TriMesh::add_room(std::uint32_t after, std::uint32_t count, MemoryAhead& ahead) {
    for_each_array_of_splits([&](auto& slots, std::size_t a_side) {
        ahead.add(slots.room(2 * a_side * after, 2 * a_side * count));
    });
}

// What a split made in the sheet of this star, along a cut.
Split TriMesh::split_of(const Star& star) const {
    Split s;
    s.m = star.m;
    s.a = star.a;
    s.b = star.b;
    s.c = star.c;
    s.bm = edge(star.bm);
    s.mc = edge(star.mc);
    s.am = edge(prev(star.mc));
    s.face3 = face(star.mc);
    s.left = {wedge(star.mc), wedge(star.bm), wedge(next(star.mc))};
    return s;
}

Split TriMesh::insert_into_sheet(EdgeId e, VertexId m) {
    const Split s = allocate_sheet(e, m);
    connect_left(s);
    if (s.right) connect_right(s);
    if (!has_uvs()) return s;
    const auto interpolate_uv = [this](const Split::Side& side) {
        uvs_[index(side.m)] = 0.5f * uv(side.b) + 0.5f * uv(side.c);
    };
    interpolate_uv(s.left);
    if (s.right && s.right->m != s.left.m) interpolate_uv(*s.right);
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
    const HalfEdgeId bc = half_edge(e);
    const HalfEdge &b = half_edges_[index(bc)], &c = half_edges_[index(next(bc))];
    const std::uint16_t level_along = level(e), level_across = level(m);
    Split s;
    s.m = m;
    s.a = origin(prev(bc));
    s.b = b.origin;
    s.c = c.origin;
    s.bm = e;
    s.left = {allocate_wedge(), b.wedge, c.wedge};
    if (!exists(b.twin)) {
        s.mc = allocate_edge(level_along);
        s.am = allocate_edge(level_across);
        s.face3 = allocate_face(face_bases_[index(face(bc))]);
        return s;
    }
    const HalfEdgeId cb = b.twin;
    s.d = origin(prev(cb));
    const WedgeId right_b = wedge(next(cb)), right_c = wedge(cb);
    const bool smooth = right_b == s.left.b && right_c == s.left.c;
    s.right = Split::Side{smooth ? s.left.m : allocate_wedge(), right_b, right_c};
    s.mc = allocate_edge(level_along);
    s.am = allocate_edge(level_across);
    s.dm = allocate_edge(level_across);
    const FaceId base3 = face_bases_[index(face(bc))], base4 = face_bases_[index(face(cb))];
    s.face3 = allocate_face(base3);
    s.face4 = allocate_face(base4);
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

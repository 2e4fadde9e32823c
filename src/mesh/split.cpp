// Splitting an edge at its midpoint.
// Source: Gain & Dodgson 1999, section 4, figure 3.
#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>

#include "mesh/midpoint_normal.h"
#include "mesh/tri_mesh.h"

namespace pectin {
namespace {

constexpr std::size_t kMostCounted = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint16_t kMostLevel = std::numeric_limits<std::uint16_t>::max();

}  // namespace

// The slot freed last, else a new one, for which reserve_for_split has made room. What it holds is
// the caller's to write.
VertexId TriMesh::allocate_vertex() {
    if (!free_vertices_.empty()) return free_vertices_.pop_value();
    for_each_array_of_vertices([](auto& slots) { slots.grow_unchecked(1); });
    return VertexId{vertex_slots() - 1};
}

WedgeId TriMesh::allocate_wedge() {
    if (!free_wedges_.empty()) return free_wedges_.pop_value();
    for_each_array_of_wedges([](auto& slots) { slots.grow_unchecked(1); });
    return WedgeId{wedge_slots() - 1};
}

EdgeId TriMesh::allocate_edge() {
    if (!free_edges_.empty()) return free_edges_.pop_value();
    for_each_array_of_edges([](auto& slots) { slots.grow_unchecked(1); });
    return EdgeId{edge_slots() - 1};
}

FaceId TriMesh::allocate_face() {
    if (!free_faces_.empty()) return free_faces_.pop_value();
    half_edges_.grow_unchecked(3);
    face_bases_.grow_unchecked(1);
    return FaceId{face_slots() - 1};
}

SplitIds TriMesh::allocate_split() {
    SplitIds ids;
    ids.m = allocate_vertex();
    ids.wedge = allocate_wedge();
    ids.mc = allocate_edge();
    ids.am = allocate_edge();
    ids.dm = allocate_edge();
    ids.face3 = allocate_face();
    ids.face4 = allocate_face();
    return ids;
}

void TriMesh::allocate_splits(std::span<SplitIds> splits) {
    reserve_splits(static_cast<std::uint32_t>(splits.size()));
    split_capacity_.splits -= static_cast<std::uint32_t>(splits.size());
    while (has_free_slots() && !splits.empty()) {
        splits.front() = allocate_split();
        splits = splits.subspan(1);
    }
    const SlotCounts first = slot_counts();
    const auto count = static_cast<std::uint32_t>(splits.size());
    for_each_array_of_vertices([&](auto& slots) { slots.grow_unchecked(count); });
    for_each_array_of_wedges([&](auto& slots) { slots.grow_unchecked(count); });
    for_each_array_of_edges([&](auto& slots) { slots.grow_unchecked(3 * std::size_t{count}); });
    half_edges_.grow_unchecked(6 * std::size_t{count});
    face_bases_.grow_unchecked(2 * std::size_t{count});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t e = first.edges + 3 * i, f = first.faces + 2 * i;
        splits[i] = {VertexId{first.vertices + i},
                     WedgeId{first.wedges + i},
                     EdgeId{e},
                     EdgeId{e + 1},
                     EdgeId{e + 2},
                     FaceId{f},
                     FaceId{f + 1}};
    }
}

bool TriMesh::has_free_slots() const {
    return !free_vertices_.empty() || !free_wedges_.empty() || !free_edges_.empty() ||
           !free_faces_.empty();
}

// Whether the split of e needs no memory: so it is where an unsplit of e is taken back.
bool TriMesh::has_slots_for_split(EdgeId e) {
    std::size_t wedges = 0, edges = 0, faces = 0;
    EdgeId sheet = e;
    do {
        const std::size_t sides = exists(twin(half_edge(sheet))) ? 2 : 1;
        wedges += sides == 2 && !is_smooth(sheet) ? 2 : 1;
        edges += 1 + sides;
        faces += sides;
        sheet = sibling(sheet);
    } while (sheet != e);
    bool suffices = true;
    const auto check = [&suffices](const auto& slots, std::size_t needed, std::size_t free) {
        if (needed > free) suffices &= slots.capacity() - slots.size() >= needed - free;
    };
    for_each_array_of_vertices([&](auto& slots) { check(slots, 1, free_vertices_.size()); });
    for_each_array_of_wedges([&](auto& slots) { check(slots, wedges, free_wedges_.size()); });
    for_each_array_of_edges([&](auto& slots) { check(slots, edges, free_edges_.size()); });
    check(half_edges_, 3 * faces, 3 * free_faces_.size());
    check(face_bases_, faces, free_faces_.size());
    return suffices;
}

EdgeId TriMesh::representative(EdgeId e) const {
    EdgeId lowest = e;
    for (EdgeId s = sibling(e); s != e; s = sibling(s)) lowest = std::min(lowest, s);
    return lowest;
}

std::uint16_t TriMesh::highest_level_around(EdgeId e) const {
    const HalfEdgeId bc = half_edge(e);
    std::uint16_t highest = std::max(level(origin(bc)), level(target(bc)));
    for_each_side(e, [&](HalfEdgeId h) { highest = std::max(highest, level(origin(prev(h)))); });
    return highest;
}

bool TriMesh::may_split(EdgeId e) const {
    return highest_level_ < kMostLevel || highest_level_around(e) < kMostLevel;
}

bool TriMesh::has_levels_for(std::uint32_t count) const {
    return highest_level_ + std::size_t{count} < kMostLevel;
}

bool TriMesh::is_smooth(EdgeId e) const {
    const HalfEdgeId h = half_edge(e), back = twin(h);
    return exists(back) && wedge(h) == wedge(next(back)) && wedge(back) == wedge(next(h));
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
    e = representative(e);
    reserve_for_split(e);
    const VertexId m = allocate_vertex();
    describe_midpoint(e, m);
    const Split s = insert_into_sheet(e, m);
    vertex_half_edges_[index(m)] = half_edge(s.face3, 0);
    if (sibling(e) != e) insert_into_siblings(s);
    return s;
}

Split TriMesh::insert_midpoint(EdgeId e, const SplitIds& ids) {
    assert(is_live(e) && highest_level_around(e) < kMostLevel && is_smooth(e));
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
    vertex_half_edges_[index(ids.m)] = half_edge(ids.face3, 0);
    return s;
}

// All but its half-edge.
void TriMesh::describe_midpoint(EdgeId e, VertexId m) {
    const VertexId b = origin(half_edge(e)), c = target(half_edge(e));
    const auto level = static_cast<std::uint16_t>(highest_level_around(e) + 1);
    record_level(level);
    vertex_levels_[index(m)] = level;
    positions_[index(m)] = Vec3{0.0};
    deformed_[index(m)] = is_deformed(b) || is_deformed(c) ? 1 : 0;
    if (has_colors()) colors_[index(m)] = 0.5f * color(b) + 0.5f * color(c);
}

// Several threads may.
void TriMesh::record_level(std::uint16_t level) {
    const std::atomic_ref highest(highest_level_);
    std::uint16_t known = highest.load(std::memory_order_relaxed);
    while (known < level && !highest.compare_exchange_weak(known, level)) {
    }
}

// For the most a split adds, before it changes anything: without the memory nothing has happened.
void TriMesh::reserve_for_split(EdgeId e) {
    const bool along_cut = sibling(e) != e;
    if (!along_cut && split_capacity_.splits > 0) {
        --split_capacity_.splits;
        return;
    }
    std::size_t sides = 0;
    for_each_side(e, [&](HalfEdgeId) { ++sides; });
    if (along_cut) sheets_.reserve(sides);
    if (has_slots_for_split(e)) {
        split_capacity_.splits = 0;  // this split takes some of it
        return;
    }
    reserve_for_sides(std::max<std::size_t>(sides, 2));
    split_capacity_.splits = along_cut ? 0 : split_capacity_.splits - 1;
}

// visit(array, elements that a side of a split adds to it at most).
template <typename Visit>
void TriMesh::for_each_array_of_splits(Visit visit) {
    for_each_array_of_vertices([&](auto& slots) { visit(slots, 1); });
    for_each_array_of_wedges([&](auto& slots) { visit(slots, 1); });
    for_each_array_of_edges([&](auto& slots) { visit(slots, 2); });
    visit(half_edges_, 3);
    visit(face_bases_, 1);
}

// Room for at least a split with so many sides, and notes how many with two there are then.
void TriMesh::reserve_for_sides(std::size_t sides) {
    std::size_t splits = kMostCounted;
    for_each_array_of_splits([&](auto& slots, std::size_t a_side) {
        slots.reserve_additional(a_side * sides);
        splits = std::min(splits, (slots.capacity() - slots.size()) / (2 * a_side));
    });
    split_capacity_.splits = static_cast<std::uint32_t>(splits);
}

void TriMesh::reserve_splits(std::uint32_t count) {
    if (split_capacity_.splits < count) reserve_for_sides(2 * std::size_t{count});
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
    Split s = before_split(e);
    s.m = m;
    s.left.m = allocate_wedge();
    if (s.right) s.right->m = s.is_smooth() ? s.left.m : allocate_wedge();
    s.mc = allocate_edge();
    s.am = allocate_edge();
    if (s.right) s.dm = allocate_edge();
    s.face3 = allocate_face();
    if (s.right) s.face4 = allocate_face();
    connect(s);
    return s;
}

// What there is at an edge, in the sheet of its half-edge.
Split TriMesh::before_split(EdgeId e) const {
    const HalfEdgeId bc = half_edge(e);
    const HalfEdge &b = half_edges_[index(bc)], &c = half_edges_[index(next(bc))];
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

// Writes all that the new slots hold, but of m.
void TriMesh::connect(const Split& s) {
    const HalfEdgeId bc = half_edge(s.bm);
    face_bases_[index(s.face3)] = face_bases_[index(face(bc))];
    if (s.right) face_bases_[index(s.face4)] = face_bases_[index(face(twin(bc)))];
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
    edge_levels_[index(e)] = level;
    if (!siblings_.empty()) siblings_[index(e)] = e;
}

void TriMesh::describe_wedge(const Split::Side& side) {
    normals_[index(side.m)] = Vec3f{0.0f};
    if (has_uvs()) uvs_[index(side.m)] = 0.5f * uv(side.b) + 0.5f * uv(side.c);
}

// The siblings of the edge that `representative` has split, about the same m. Along bm and along mc
// the pieces become siblings, in the order that the edges had.
//
//      a1 a2             a1 a2
//      | / |             |\./|
//      b===c   ---->     b=m=c     here sheets 1 and 2 run the same way; where one runs from c to
//                                  b, its own bm lies along the others' mc
void TriMesh::insert_into_siblings(const Split& representative) {
    EdgeId along_bm = representative.bm, along_mc = representative.mc;
    const auto append = [this](EdgeId& last, EdgeId e) {
        siblings_[index(last)] = e;
        last = e;
    };
    for (EdgeId e = sibling(representative.bm), next = e; e != representative.bm; e = next) {
        next = sibling(e);
        const Split s = insert_into_sheet(e, representative.m);
        const bool same_way = s.b == representative.b;
        append(along_bm, same_way ? s.bm : s.mc);
        append(along_mc, same_way ? s.mc : s.bm);
    }
    append(along_bm, representative.bm);
    append(along_mc, representative.mc);
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

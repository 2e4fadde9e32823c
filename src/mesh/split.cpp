// Splitting an edge at its midpoint and undoing that exactly.
// Source: Gain & Dodgson 1999, section 4, figure 3.
#include <algorithm>
#include <cassert>
#include <limits>

#include "mesh/tri_mesh.h"

namespace pectin {
namespace {

// Below this the sum of two unit normals says nothing of a direction: its ends oppose each other
// (by more than 174 degrees), and the face normal is added.
constexpr double kShortNormalSum = 0.1;

}  // namespace

Vec3f midpoint_normal(const Vec3f& nb, const Vec3f& nc, const Vec3& area_normal) {
    Vec3 sum = Vec3{nb} + Vec3{nc};
    double squared = glm::dot(sum, sum);
    if (squared < kShortNormalSum * kShortNormalSum) {
        const double area = glm::length(area_normal);
        if (area > 0.0) sum += area_normal / area;
        squared = glm::dot(sum, sum);
    }
    return squared > 0.0 ? Vec3f{sum / std::sqrt(squared)} : Vec3f{0.0f};
}

// Gives half-edge `from` the slot `to`; whatever names it follows. Its origin, wedge and edge go
// along, its own face is the caller's business.
void TriMesh::move_half_edge(HalfEdgeId from, HalfEdgeId to) {
    HalfEdge& moved = half_edges_[index(to)];
    moved = half_edges_[index(from)];
    if (exists(moved.twin)) half_edges_[index(moved.twin)].twin = to;
    HalfEdgeId& of_vertex = vertex_half_edges_[index(moved.origin)];
    if (of_vertex == from) of_vertex = to;
    HalfEdgeId& of_edge = edge_half_edges_[index(moved.edge)];
    if (of_edge == from) of_edge = to;
}

void TriMesh::link(HalfEdgeId h, HalfEdgeId twin) {
    half_edges_[index(h)].twin = twin;
    half_edges_[index(twin)].twin = h;
}

bool TriMesh::may_split(EdgeId e) const {
    const HalfEdgeId bc = half_edge(e);
    std::uint16_t highest =
        std::max({level(origin(bc)), level(target(bc)), level(origin(prev(bc)))});
    if (exists(twin(bc))) highest = std::max(highest, level(origin(prev(twin(bc)))));
    return highest < std::numeric_limits<std::uint16_t>::max();
}

Split TriMesh::split(EdgeId e) {
    const Split s = insert_midpoint(e);
    positions_[index(s.m)] = 0.5 * position(s.b) + 0.5 * position(s.c);
    const auto set_normal_of = [this](const Split::Side& side, const Vec3& area_normal) {
        normals_[index(side.m)] = midpoint_normal(normal(side.b), normal(side.c), area_normal);
    };
    const Vec3 bc = position(s.c) - position(s.b);
    set_normal_of(s.left, glm::cross(bc, position(s.a) - position(s.b)));
    if (s.right && s.right->m != s.left.m) {
        set_normal_of(*s.right, glm::cross(position(s.d) - position(s.b), bc));
    }
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
//  Allocation order: m; its wedges; mc, am, dm; faces 3, 4. unsplit releases in reverse.
Split TriMesh::insert_midpoint(EdgeId e) {
    assert(is_live(e) && may_split(e));
    make_room();
    const Split s = allocate_midpoint(e);
    connect_left(s);
    if (s.right) connect_right(s);
    const auto interpolate_uv = [this](const Split::Side& side) {
        uvs_[index(side.m)] = 0.5f * uv(side.b) + 0.5f * uv(side.c);
    };
    if (has_uvs()) {
        interpolate_uv(s.left);
        if (s.right && s.right->m != s.left.m) interpolate_uv(*s.right);
    }
    deformed_[index(s.m)] = is_deformed(s.b) || is_deformed(s.c) ? 1 : 0;
    return s;
}

// For the most a split adds, before it changes anything: without the memory nothing has happened.
void TriMesh::make_room() {
    const auto room = [](auto& slots, std::size_t added) {
        if (slots.capacity() - slots.size() < added) slots.reserve(2 * slots.size() + added);
    };
    room(positions_, 1);
    room(vertex_half_edges_, 1);
    room(vertex_levels_, 1);
    room(deformed_, 1);
    room(normals_, 2);
    if (has_uvs()) room(uvs_, 2);
    room(edge_half_edges_, 3);
    room(edge_levels_, 3);
    room(half_edges_, 6);
    room(face_bases_, 2);
}

Split TriMesh::allocate_midpoint(EdgeId e) {
    const HalfEdgeId bc = half_edge(e), ca = next(bc), cb = twin(bc);
    Split s;
    s.b = origin(bc);
    s.c = origin(ca);
    s.a = origin(prev(bc));
    s.bm = e;
    s.left.b = wedge(bc);
    s.left.c = wedge(ca);
    std::uint16_t highest = std::max({level(s.a), level(s.b), level(s.c)});
    if (exists(cb)) {
        s.d = origin(prev(cb));
        s.right = Split::Side{kNone<WedgeId>, wedge(next(cb)), wedge(cb)};
        highest = std::max(highest, level(s.d));
    }

    s.m = allocate_vertex();
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

    const auto m_level = static_cast<std::uint16_t>(highest + 1);
    vertex_levels_[index(s.m)] = m_level;
    edge_levels_[index(s.mc)] = level(e);
    edge_levels_[index(s.am)] = m_level;
    if (s.right) edge_levels_[index(s.dm)] = m_level;
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
    vertex_half_edges_[index(s.m)] = mc;
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

std::optional<Star> TriMesh::removable(VertexId m) const {
    if (is_base(m) || !is_live(m)) return std::nullopt;
    Star star;
    star.m = m;
    star.mc = half_edge(m);
    const HalfEdgeId am = prev(star.mc), ma = twin(am);
    if (!exists(ma)) return std::nullopt;
    star.bm = prev(ma);
    star.a = origin(am);
    star.b = origin(star.bm);
    star.c = target(star.mc);
    std::uint16_t highest = std::max({level(star.a), level(star.b), level(star.c)});
    star.mb = twin(star.bm);
    star.cm = twin(star.mc);
    if (exists(star.mb) != exists(star.cm)) return std::nullopt;
    if (exists(star.mb)) {
        const HalfEdgeId dm = prev(star.mb);
        // A fourth edge closes the star; with a fifth, md lies in another face than cm.
        if (twin(dm) != next(star.cm)) return std::nullopt;
        star.d = origin(dm);
        highest = std::max(highest, level(star.d));
    }
    if (highest > level(m)) return std::nullopt;
    return star;
}

// The reverse of insert_midpoint, statement by statement.
EdgeId TriMesh::unsplit(const Star& star) {
    const HalfEdgeId bc = star.bm, ma = next(bc);
    const FaceId face3 = face(star.mc);
    const HalfEdgeId ca = next(star.mc);
    const EdgeId e = edge(bc), mc_edge = edge(star.mc), am_edge = edge(ma);
    const WedgeId left_m = wedge(star.mc);
    assert(ca == half_edge(face3, 1) && level(am_edge) == level(star.m));

    if (!star.on_boundary()) {
        const HalfEdgeId mb = star.mb, dm = prev(mb);
        const FaceId face4 = face(star.cm);
        const EdgeId dm_edge = edge(dm);
        const WedgeId right_m = wedge(mb);
        assert(star.cm == half_edge(face4, 0) && level(dm_edge) == level(star.m));
        half_edges_[index(star.cm)].edge = e;
        move_half_edge(half_edge(face4, 2), dm);
        move_half_edge(star.cm, mb);
        link(bc, mb);
        move_half_edge(ca, ma);
        release(face4);
        release(face3);
        release(dm_edge);
        release(am_edge);
        release(mc_edge);
        if (right_m != left_m) release(right_m);
    } else {
        move_half_edge(ca, ma);
        release(face3);
        release(am_edge);
        release(mc_edge);
    }
    release(left_m);
    release(star.m);
    return e;
}

}  // namespace pectin

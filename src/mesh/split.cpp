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
        const Vec3& b = position(origin(from_b));
        const Vec3 area_normal = glm::cross(position(origin(from_c)) - b, position(apex) - b);
        normals_[index(m)] =
            midpoint_normal(normal(wedge(from_b)), normal(wedge(from_c)), area_normal);
    };
    for_each_sheet(*star_from(half_edge(s.m)), [&](const Star& star) {
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
    std::size_t sides = 0;
    for_each_side(e, [&](HalfEdgeId) { ++sides; });
    const auto room = [](auto& slots, std::size_t added) {
        if (slots.capacity() - slots.size() < added) slots.reserve(2 * slots.size() + added);
    };
    room(positions_, 1);
    room(vertex_half_edges_, 1);
    room(vertex_levels_, 1);
    room(deformed_, 1);
    if (has_colors()) room(colors_, 1);
    room(normals_, sides);
    if (has_uvs()) room(uvs_, sides);
    const std::size_t edges = 2 * sides;
    room(edge_half_edges_, edges);
    room(edge_levels_, edges);
    if (!siblings_.empty()) room(siblings_, edges);
    room(half_edges_, 3 * sides);
    room(face_bases_, sides);
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

std::optional<Star> TriMesh::removable(VertexId m) const {
    if (is_base(m) || !is_live(m)) return std::nullopt;
    const std::optional<Star> star = star_from(half_edge(m));
    if (!star || !star->on_boundary()) return star;
    const EdgeId first = edge(star->mc);
    for (EdgeId e = sibling(first); e != first; e = sibling(e)) {
        if (!sheet(m, e)) return std::nullopt;
    }
    return star;
}

// The star that has m->c in its face 3, if it is closed with four edges, or has three and lies on
// the boundary, and all neighbours are at m's level or lower.
std::optional<Star> TriMesh::star_from(HalfEdgeId mc) const {
    Star star;
    star.m = origin(mc);
    star.mc = mc;
    const HalfEdgeId am = prev(mc), ma = twin(am);
    if (!exists(ma)) return std::nullopt;
    star.bm = prev(ma);
    star.a = origin(am);
    star.b = origin(star.bm);
    star.c = target(mc);
    std::uint16_t highest = std::max({level(star.a), level(star.b), level(star.c)});
    star.mb = twin(star.bm);
    star.cm = twin(mc);
    if (exists(star.mb) != exists(star.cm)) return std::nullopt;
    if (exists(star.mb)) {
        const HalfEdgeId dm = prev(star.mb);
        // A fourth edge closes the star; with a fifth, md lies in another face than cm.
        if (twin(dm) != next(star.cm)) return std::nullopt;
        star.d = origin(dm);
        highest = std::max(highest, level(star.d));
    }
    if (highest > level(star.m)) return std::nullopt;
    return star;
}

// The star in the sheet that has this boundary edge at m: its m->c, or its b->m where the sheet
// runs the other way.
std::optional<Star> TriMesh::sheet(VertexId m, EdgeId along_cut) const {
    const HalfEdgeId h = half_edge(along_cut);
    if (origin(h) == m) return star_from(h);
    const HalfEdgeId am = twin(next(h));
    return exists(am) ? star_from(next(am)) : std::nullopt;
}

// The reverse of insert_midpoint, statement by statement.
EdgeId TriMesh::unsplit(const Star& star) {
    if (star.on_boundary() && sibling(edge(star.mc)) != edge(star.mc)) unsplit_siblings(star);
    const EdgeId e = unsplit_sheet(star);
    release(star.m);
    return e;
}

void TriMesh::unsplit_siblings(const Star& leader) {
    std::vector<Star> sheets;
    for_each_sheet(leader, [&](const Star& star) { sheets.push_back(star); });
    for (std::size_t i = sheets.size(); i-- > 0;) {
        const EdgeId e = edge(sheets[i].bm);
        assert(e >= edge(leader.bm));
        siblings_[index(e)] = edge(sheets[(i + 1) % sheets.size()].bm);
        if (i > 0) unsplit_sheet(sheets[i]);
    }
}

EdgeId TriMesh::unsplit_sheet(const Star& star) {
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
    return e;
}

}  // namespace pectin

// Undoing the split of an edge exactly: the reverse of split.cpp, statement by statement.
//
//           a                          a
//          /|\.                       / \.
//         /1|3\.       unsplit       / 1 \.
//        b--m--c      -------->     b-----c
//         \2|4/                      \ 2 /
//          \|/                        \ /
//           d                          d
//
// Edge bm, and faces 1 and 2, keep their slots. c->a, d->c and c->b return from faces 3 and 4 to
// the slots of m->a, d->m and m->b. The slots of faces 4 and 3; dm, am, mc; the wedges at m, right
// before left; and m are released in this order (invariant 12 of TriMesh).
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999, section 4 and figure 3.
#include <algorithm>
#include <cassert>

#include "mesh/tri_mesh.h"

namespace pectin {

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

// The star with m->c in its face 3. None unless it is closed with four edges, or has three and lies
// on the boundary, and no neighbour has a higher level than m.
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
        // A fourth edge closes the star. If there is a fifth, the twin of dm is not in face 4.
        if (twin(dm) != next(star.cm)) return std::nullopt;
        star.d = origin(dm);
        highest = std::max(highest, level(star.d));
    }
    if (highest > level(star.m)) return std::nullopt;
    return star;
}

EdgeId TriMesh::unsplit(const Star& star) {
    if (star.on_boundary() && sibling(edge(star.mc)) != edge(star.mc)) unsplit_siblings(star);
    const EdgeId e = unsplit_sheet(star);
    vertices_.release(star.m);
    return e;
}

EdgeId TriMesh::unsplit_sheet(const Star& star) {
    const SplitIds ids = ids_of(star);
    const EdgeId e = edge(star.bm);
    if (!star.on_boundary()) {
        const WedgeId right_m = wedge(star.mb);
        disconnect_right(star, ids);
        disconnect_left(star, ids);
        faces_.release(ids.face4);
        faces_.release(ids.face3);
        edges_.release(ids.dm);
        edges_.release(ids.am);
        edges_.release(ids.mc);
        if (right_m != ids.wedge) wedges_.release(right_m);
    } else {
        disconnect_left(star, ids);
        faces_.release(ids.face3);
        edges_.release(ids.am);
        edges_.release(ids.mc);
    }
    wedges_.release(ids.wedge);
    return e;
}

SplitIds TriMesh::remove_midpoint(const Star& star) {
    assert(!star.on_boundary() && wedge(star.mb) == wedge(star.mc));
    const SplitIds ids = ids_of(star);
    disconnect_right(star, ids);
    disconnect_left(star, ids);
    faces_.clear(ids.face4);
    faces_.clear(ids.face3);
    edges_.clear(ids.dm);
    edges_.clear(ids.am);
    edges_.clear(ids.mc);
    wedges_.clear(ids.wedge);
    vertices_.clear(ids.m);
    return ids;
}

// The slots that the split took. On a boundary there is no dm and no face 4. On a crease this holds
// only the left of the two wedges at m.
SplitIds TriMesh::ids_of(const Star& star) const {
    SplitIds ids;
    ids.m = star.m;
    ids.wedge = wedge(star.mc);
    ids.mc = edge(star.mc);
    ids.am = edge(prev(star.mc));
    ids.face3 = face(star.mc);
    if (star.on_boundary()) return ids;
    ids.dm = edge(prev(star.mb));
    ids.face4 = face(star.cm);
    return ids;
}

//      a              a
//     /|\.           / \.
//    /1|3\.  --->   / 1 \.
//   b--m--c        b-----c
void TriMesh::disconnect_left(const Star& star, [[maybe_unused]] const SplitIds& ids) {
    const HalfEdgeId ma = next(star.bm), ca = next(star.mc);
    assert(ca == half_edge(ids.face3, 1) && level(ids.am) == level(star.m));
    move_half_edge(ca, ma);
}

//   b--m--c        b-----c
//    \2|4/   --->   \ 2 /
//     \|/            \ /
//      d              d
void TriMesh::disconnect_right(const Star& star, const SplitIds& ids) {
    const HalfEdgeId mb = star.mb, dm = prev(mb);
    assert(star.cm == half_edge(ids.face4, 0) && level(ids.dm) == level(star.m));
    faces_.half_edges[index(star.cm)].edge = edge(star.bm);
    move_half_edge(half_edge(ids.face4, 2), dm);
    move_half_edge(star.cm, mb);
    link(star.bm, mb);
}

}  // namespace pectin

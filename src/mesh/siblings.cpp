// Splitting and unsplitting the siblings along a cut about one midpoint.
//
// Two or more sheets share the vertices b and c of a cut, and each has an edge bc of its own. These
// siblings form a ring (TriMesh::sibling). The apex of sheet i is ai:
//
//         a1                        a1
//        / \                       /|\.
//       /   \        split        / | \.        Sheet 1.
//      b-----c      ------->     b--m--c
//      b-----c      unsplit      b--m--c        Sheet 2. Here it is drawn apart from sheet 1, but
//       \   /       <------       \ | /         both share the vertices b and c, and after the
//        \ /                       \|/          split also m. Each has edges of its own.
//         a2                        a2
//
// After the split the halves along bm are siblings of each other, and so are those along mc, in the
// order that the edges had in the ring. A sheet whose half-edge runs from c to b has its own bm
// along the others' mc.
#include <cassert>

#include "mesh/tri_mesh.h"

namespace pectin {

// Splits the siblings of the edge that has become `representative`, about the same m.
void TriMesh::insert_into_siblings(const Split& representative) {
    EdgeId along_bm = representative.bm, along_mc = representative.mc;
    const auto append = [this](EdgeId& last, EdgeId e) {
        edges_.siblings[index(last)] = e;
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

// Joins the siblings of bc again, and unsplits all sheets but the representative's.
void TriMesh::unsplit_siblings(const Star& representative) {
    sheets_.clear();
    for_each_sheet(representative, [&](const Star& star) { sheets_.push_back(star); });
    for (std::size_t i = sheets_.size(); i-- > 0;) {
        const EdgeId e = edge(sheets_[i].bm);
        assert(e >= edge(representative.bm));
        edges_.siblings[index(e)] = edge(sheets_[(i + 1) % sheets_.size()].bm);
        if (i > 0) unsplit_sheet(sheets_[i]);
    }
}

// The star of m in the sheet that has `along_cut`, a boundary edge at m. That edge is the sheet's
// m->c, or its b->m if the sheet runs the other way.
std::optional<Star> TriMesh::sheet(VertexId m, EdgeId along_cut) const {
    const HalfEdgeId h = half_edge(along_cut);
    if (origin(h) == m) return star_from(h);
    const HalfEdgeId am = twin(next(h));
    return exists(am) ? star_from(next(am)) : std::nullopt;
}

// Describes the split that made this star, in one sheet along a cut.
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

}  // namespace pectin

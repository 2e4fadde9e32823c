// Counts the self-intersections of a gesture from their definition, without the data structures,
// the passes and the predicate of the search that it checks.
#pragma once

#include <cstddef>

#include "mesh/tri_mesh.h"

namespace pectin::test {

// The number of pairs of an edge and a face that share no corner, intersect in `now`, and were
// apart in `rest`, which has the same faces in the same slots. Edges that end on a face, and faces
// without area, do not count. Vertices move where their positions in the two meshes differ; pairs
// in which nothing moves are not tested. Cost: O(n log n + pairs whose boxes overlap along x).
std::size_t new_intersections(const TriMesh& now, const TriMesh& rest);

}  // namespace pectin::test

// Diagonals that have the same two ends as another edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/ids.h"
#include "mesh/indexed_face_set.h"

namespace pectin {

// Replaces diagonals of polygons that join the same two vertices as another edge of the mesh by the
// other diagonal of their two triangles, where that one joins two vertices that no edge joins yet
// and both new triangles face the polygon's way. This is repeated until no such exchange is left.
//
// What is replaced depends neither on the order of the polygons nor on their first corners, and
// mirroring the mesh in any axis through `centre` mirrors it. In each pass all such diagonals are
// exchanged except two kinds, which the next pass looks at again. Of two diagonals of one triangle
// the one with the shorter replacement comes first, then the one with the midpoints nearest to the
// mirror planes, then the one on the positive side. So it is where two replacements would meet at
// the same ends, but there both diagonals stay if only their sides differ.
//
//   corner_of      3 n_faces; into input.corners; the faces of a polygon lie side by side
//   polygon_of     n_faces
//   half_edges     all that share their ends with more than one other; 3 f + k runs from corner k
//                  of face f to the next
//
// Returns the polygons whose triangles have changed, ascending. Cost: O(1) where none of the
// half-edges is a diagonal, else O(n), and O(d log d) for each pass over d shared diagonals.
std::vector<std::uint32_t> exchange_shared_diagonals(const IndexedFaceSet& input,
                                                     std::span<const Vec3> positions,
                                                     const Vec3& centre,
                                                     std::span<const std::uint32_t> polygon_of,
                                                     std::span<const HalfEdgeId> half_edges,
                                                     std::vector<std::uint32_t>& corner_of);

}  // namespace pectin

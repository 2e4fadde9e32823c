// Exchanges diagonals that have the same two ends as another edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/ids.h"
#include "mesh/indexed_face_set.h"

namespace pectin {

// A diagonal of a polygon that joins the same two vertices as another edge of the mesh is replaced
// by the other diagonal of its two triangles, if no edge joins the ends of that one yet and both
// new triangles face the same way as the polygon. This is repeated until no such exchange is left.
//
// The result depends neither on the order of the polygons nor on their first corners, and mirroring
// the mesh along any axis through `centre` mirrors the result. Each pass exchanges all such
// diagonals with two exceptions, which are left for the next pass. Of two diagonals of one triangle
// only the first is exchanged: the one with the shorter replacement, then the one whose midpoints
// are nearest to the mirror planes, then the one on the positive side. The same order decides
// between two replacements that have the same ends; but if only their sides differ, neither is
// exchanged.
//
//   corner_of      3 n_faces; index into input.corners; the faces of a polygon are adjacent
//   polygon_of     n_faces
//   half_edges     all that share their ends with more than one other half-edge; 3 f + k runs
//                  from corner k of face f to the next
//
// Returns the polygons whose triangles have changed, ascending. Cost: O(1) if no
// half-edge is a diagonal, otherwise O(n) and O(d log d) per pass over d shared diagonals.
std::vector<std::uint32_t> exchange_shared_diagonals(const IndexedFaceSet& input,
                                                     std::span<const Vec3> positions,
                                                     const Vec3& centre,
                                                     std::span<const std::uint32_t> polygon_of,
                                                     std::span<const HalfEdgeId> half_edges,
                                                     std::vector<std::uint32_t>& corner_of);

}  // namespace pectin

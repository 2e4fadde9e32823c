// Vertex colours as the input shares its vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/unshared_vertices.h"

namespace pectin {

// Colours of all vertices that UnsharedVertices tells of, by its numbers. The mesh has one colour
// where a seam has joined vertices; where these differ, inserted vertices get on each side the mean
// of the colours there, as those in a mesh without seams do. Nothing where the mesh's own colours
// are right, or it has none.
// Cost: O(n log n), with a copy of the mesh, where colours differ across a seam; else O(n).
std::optional<std::vector<Vec3f>> unshared_colors(const TriMesh& mesh,
                                                  const UnsharedVertices& vertices);

}  // namespace pectin

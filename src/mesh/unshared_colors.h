// Vertex colours for the vertices of UnsharedVertices.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/unshared_vertices.h"

namespace pectin {

// The colours of all vertices of `vertices`, by their numbers there. Where a seam has joined
// vertices the mesh has only one colour. If the colours on its two sides differ, a vertex inserted
// on the seam gets on each side the mean of the colours on that side, as in a mesh without seams.
// None if the colours of the mesh are right already, or if it has none. Cost: O(n log n) and a copy
// of the mesh if colours differ across a seam, otherwise O(n).
std::optional<std::vector<Vec3f>> unshared_colors(const TriMesh& mesh,
                                                  const UnsharedVertices& vertices);

}  // namespace pectin

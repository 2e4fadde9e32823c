// Normals for the corners of a mesh under construction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/build_mesh.h"

namespace pectin {

// The normal of every half-edge's corner: the input's where it has one, else the mean of the
// faces round the vertex, weighted by corner angle (Thürmer & Wüthrich 1998), over those joined
// to it across smooth edges. An edge is smooth if its faces share a smoothing group (other than
// 0), or, where the input has no smoothing groups, turn by at most options.crease_angle.
// `mesh`: faces, twins and positions are set. `corner_of`: 3 n_faces, into input.corners.
// Cost: O(n).
std::vector<Vec3f> corner_normals(const TriMesh& mesh, const IndexedFaceSet& input,
                                  std::span<const std::uint32_t> corner_of,
                                  const BuildOptions& options);

}  // namespace pectin

// The part of a surface that hangs together inside the zones of a drag.
#pragma once

#include <span>
#include <vector>

#include "geometry/box.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// Of `faces` (live, sorted, those that meet the zones) the ones that can be reached from `seeds`
// (any faces; those that are not among `faces` reach nothing) without leaving the zones: across an
// edge that meets a zone, or across a vertex strictly inside one, where sheets may touch that have
// no edge in common. So every face at a vertex that moves is in, or none is. Sorted.
// Cost: O(n log n) in the faces.
std::vector<FaceId> connected_part(const TriMesh& mesh, std::span<const FaceId> faces,
                                   std::span<const FaceId> seeds, std::span<const Box> zones);

}  // namespace pectin

// The connected part of a surface inside the zones of a drag.
#pragma once

#include <span>
#include <vector>

#include "geometry/box.h"
#include "mesh/tri_mesh.h"

namespace pectin {

struct ConnectedPart {
    std::vector<FaceId> faces;   // sorted
    std::vector<FaceId> others;  // the rest of the given faces, sorted
};

// Finds the faces among `faces` that can be reached from `seeds` without leaving the zones. A step
// leads across an edge that meets a zone, or across a vertex strictly inside one, since sheets
// without a common edge may touch there. Hence either all faces at a moving vertex are included, or
// none is. `faces`: live, sorted, those that meet the zones. `seeds`: any faces; those that are not
// among `faces` are ignored. Cost: nearly O(faces), on all threads; O(k log k) in the faces at the
// border of the zones.
ConnectedPart connected_part(const TriMesh& mesh, std::span<const FaceId> faces,
                             std::span<const FaceId> seeds, std::span<const Box> zones);

}  // namespace pectin

// The figures that a scan of the mesh gives.
#pragma once

#include "command/statistics.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// Counts, max_level, edge_max and angle_min_deg of `statistics`. Cost: O(n).
void measure(const TriMesh& mesh, Statistics& statistics);

}  // namespace pectin

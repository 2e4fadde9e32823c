// The statistics that follow from the mesh alone.
#pragma once

#include "command/statistics.h"
#include "mesh/tri_mesh.h"

namespace pectin {

// Sets the counts, max_level, edge_max and angle_min_deg of `statistics`. Cost: O(n).
void measure(const TriMesh& mesh, Statistics& statistics);

}  // namespace pectin

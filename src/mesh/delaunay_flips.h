// The diagonals of a triangulated polygon exchanged for better ones.
#pragma once

#include <vector>

#include "mesh/ear_clipping.h"

namespace pectin {

// Makes the triangulation constrained Delaunay, with angles measured in space: a diagonal whose
// opposite angles sum to more than two right angles is replaced by the other one of its two
// triangles, where these form a strictly convex quad; of two that are equally good the shorter one
// stays (C. L. Lawson. Software for C1 surface interpolation. Mathematical Software III (1977)).
// All triangles keep turning counter-clockwise. Precondition: none turns clockwise.
// Cost: O(n log n), and O(1) for each flip, of which ears need about as many as there are corners.
void flip_to_delaunay(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles);

}  // namespace pectin

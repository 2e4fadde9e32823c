// Improves the diagonals of a triangulated polygon by flips.
// Source: C. L. Lawson. Software for C1 surface interpolation. Mathematical Software III (1977).
#pragma once

#include <vector>

#include "mesh/ear_clipping.h"

namespace pectin {

// Makes the triangulation constrained Delaunay (Lawson 1977), with angles measured in space. A
// diagonal is flipped if its opposite angles sum to more than two right angles and its two
// triangles form a strictly convex quad. Of two equally good diagonals the shorter one is chosen.
// All triangles stay counter-clockwise. Precondition: none is clockwise. Cost: O(n log n) and O(1)
// per flip; a triangulation by ear clipping needs about one flip per corner.
void flip_to_delaunay(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles);

}  // namespace pectin

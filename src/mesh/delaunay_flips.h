// Improves the diagonals of a triangulated polygon by flips.
// Source: C. L. Lawson. Software for C1 surface interpolation. Mathematical Software III (1977).
#pragma once

#include <vector>

#include "mesh/ear_clipping.h"

namespace pectin {

// Makes the triangulation constrained Delaunay (Lawson 1977), with angles measured in the polygon's
// plane. A diagonal is flipped if its opposite angles sum to more than two right angles and its two
// triangles form a strictly convex quad. Triangles are processed from the last to the first, in the
// reverse of the order in which ears were cut off. Then triangles whose corners lie on one circle
// are cut again by clip_ears, so that the result does not depend on the given triangles. All
// triangles stay counter-clockwise. Precondition: none is clockwise. Returns the number of flips. A
// triangulation by ear clipping needs about one per corner. Cost: O(n log n) and O(1) per flip.
// After 128 n flips the remaining diagonals stay as they are; two long curves that bend away from
// each other can reach this limit.
std::size_t flip_to_delaunay(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles);

}  // namespace pectin

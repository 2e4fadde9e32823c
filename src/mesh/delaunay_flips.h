// The diagonals of a triangulated polygon exchanged for better ones.
#pragma once

#include <vector>

#include "mesh/ear_clipping.h"

namespace pectin {

// Makes the triangulation constrained Delaunay, with angles measured in the polygon's plane: a
// diagonal whose opposite angles sum to more than two right angles is replaced by the other one of
// its two triangles, where these form a strictly convex quad (C. L. Lawson. Software for C1 surface
// interpolation. Mathematical Software III (1977)). The triangles are taken up from the last to the
// first, as if ears were put back that had been cut off. Then triangles whose corners lie on one
// circle are cut anew by clip_ears, so that the result does not depend on the triangles given.
// All triangles keep turning counter-clockwise. Precondition: none turns clockwise.
// Returns the number of flips. Ears need about as many as there are corners.
// Cost: O(n log n) and O(1) for each flip. After 128 n flips the rest stays as it is; two long
// curves that bend away from each other can come to this.
std::size_t flip_to_delaunay(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles);

}  // namespace pectin

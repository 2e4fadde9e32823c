// Triangulates polygons.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace pectin {

// Appends n - 2 triangles of the polygon with these corners (in order, at least 3), as indices of
// corners, each with the polygon's orientation. Quads get the diagonal of choose_diagonal. Larger
// polygons are projected along the axis nearest to their normal, so that no coordinate is rounded,
// triangulated by clip_ears or by a sweep, and made constrained Delaunay. Except for ties in
// polygons that are their own mirror image, the result does not depend on the first corner, and
// mirroring the polygon along any axis through `centre` mirrors it (unless the search for ears of a
// large polygon that intersects itself reaches its limit for only one of the two, since the number
// of steps depends on the axes). Returns whether the triangles cover exactly the polygon. They do
// unless it intersects itself (if it is not flat: in that projection and in its own plane), except
// in rare cases: large polygons that touch themselves both on their inside and on their outside, or
// at very small angles, where rounding prevents it. Cost: O(n log n) for polygons that do not touch
// or intersect themselves and for all with more than kMostCornersOfSmall corners; for others the
// cost of clip_ears.
bool triangulate(std::span<const Vec3> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles,
                 const Vec3& centre = Vec3{0.0});

}  // namespace pectin

// Polygons to triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace pectin {

// Appends the triangles of the polygon with these corners (in order, at least 3), as indices of
// corners, each with the polygon's orientation. Quads are cut along 0-2 unless only 1-3 keeps
// both halves facing the polygon's way. Larger polygons are cut by ears (Meisters 1975) in the
// plane of their Newell normal; convex ones become fans. Polygons that cross themselves or have no
// area get some triangulation of n - 2 triangles. Cost: about O(n) for most polygons, since corners
// that lie in an ear are looked up in a grid; O(n^2) at worst, with a bound that only polygons
// which cross themselves meet.
void triangulate(std::span<const Vec3> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace pectin

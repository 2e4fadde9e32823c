// Triangulates a plane polygon that may touch itself with a sweep line.
#pragma once

#include <optional>
#include <span>

#include "geometry/vec.h"
#include "mesh/monotone_sweep.h"

namespace pectin {

// Triangulates a polygon whose corners are in counter-clockwise order. It may touch itself at
// corners, at points inside of sides, or along sides (such as bridges to holes), and corners may
// repeat the one before. First corners at which the outline turns back on itself are cut off as
// triangles without area. Then each corner is moved an infinitesimal distance into the polygon
// along the bisector of its angle, which makes the polygon simple, and sweep_triangles is called.
// Returns none if it finds that the polygon intersects itself. It does not always find this, and
// rounding may have turned the bisector of a very small angle to the outside; some triangles may
// then be clockwise. Cost: O(n log n).
std::optional<SweptPolygon> sweep_touching_polygon(std::span<const Vec2> points);

}  // namespace pectin

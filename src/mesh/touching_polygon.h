// Triangulates, with a sweep line, a plane polygon that may touch itself.
#pragma once

#include <optional>
#include <span>

#include "geometry/vec.h"
#include "mesh/monotone_sweep.h"

namespace pectin {

// Where a polygon touches itself: on its outside, so that a part of the outside has no width (as
// along a bridge to a hole), or on its inside, so that a part of the polygon has no width.
enum class Touch { outside, inside };

// Triangulates a polygon whose corners are in counter-clockwise order. It may touch itself in
// corners and along sides, and corners may repeat the one before. Corners at which the outline
// turns back on itself are cut off first, as triangles without area. Then each corner is moved an
// infinitesimal distance along the bisector of its angle, into the polygon if it touches itself on
// its outside, otherwise out of it. This makes the polygon simple, and sweep_triangles is called.
// Returns none if it finds that the polygon intersects itself or touches itself on the other side.
// It does not always find this, and rounding may have turned the bisector of a very small angle;
// some triangles may then be clockwise. Cost: O(n log n).
std::optional<SweptPolygon> sweep_touching_polygon(std::span<const Vec2> points, Touch touch);

}  // namespace pectin

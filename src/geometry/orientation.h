// The exact orientation of three points of the plane.
// Source: J. R. Shewchuk. Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates. Discrete & Computational Geometry 18 (1997).
#pragma once

#include "geometry/vec.h"

namespace pectin {

// Returns 1 if a, b, c are in counter-clockwise order, -1 if clockwise, and 0 if they are
// collinear. Exact for all coordinates whose products neither overflow nor underflow. Cost: a few
// operations, or about a hundred if rounding could decide.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

struct MovingPoint {
    Vec2 at, velocity;
};

// Returns the orientation that the points have at all sufficiently small times after 0; 0 if they
// stay collinear. Exact under the same condition.
int orientation(const MovingPoint& a, const MovingPoint& b, const MovingPoint& c);

}  // namespace pectin

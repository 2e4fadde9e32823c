// The exact orientation of three points of the plane.
#pragma once

#include "geometry/vec.h"

namespace pectin {

// 1 where a, b, c turn counter-clockwise, -1 where they turn clockwise, 0 where they lie on one
// line. Exact for all coordinates whose products neither overflow nor underflow.
// Cost: a few operations; about a hundred where rounding could decide.
// Source: J. R. Shewchuk. Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates. Discrete & Computational Geometry 18 (1997).
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace pectin

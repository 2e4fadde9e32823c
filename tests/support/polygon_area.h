// Signed areas in the plane, positive in counter-clockwise order.
#pragma once

#include <cstddef>
#include <span>

#include "geometry/vec.h"

namespace pectin::test {

inline double area_of(const Vec2& a, const Vec2& b, const Vec2& c) {
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}
// Of a polygon, also if it is not convex.
inline double area_of(std::span<const Vec2> ring) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += area_of(ring[0], ring[i], ring[i + 1]);
    return sum;
}

}  // namespace pectin::test

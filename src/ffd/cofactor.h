// The cofactor matrix of a Jacobian, applied to a normal.
#pragma once

#include <cmath>

#include "geometry/vec.h"

namespace pectin {

// cof(J)·n without forming the matrix: its columns are the cross products of J's.
inline Vec3 cofactor_times(const Mat3& j, const Vec3& n) {
    return n.x * glm::cross(j[1], j[2]) + n.y * glm::cross(j[2], j[0]) +
           n.z * glm::cross(j[0], j[1]);
}

// The unit vector along x; zero where x has no direction (zero, or not finite).
inline Vec3f unit_or_zero(const Vec3& x) {
    const double squared = glm::dot(x, x);
    const bool has_direction = squared > 0.0 && std::isfinite(squared);
    return has_direction ? Vec3f{x * (1.0 / std::sqrt(squared))} : Vec3f{0.0f};
}

}  // namespace pectin

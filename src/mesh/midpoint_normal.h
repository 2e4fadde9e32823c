// The rule for a midpoint's normal.
#pragma once

#include <cmath>
#include <concepts>

#include "geometry/vec.h"

namespace pectin {

// Below this the sum of two unit normals says nothing of a direction: its ends oppose each other
// (by more than 174 degrees), and the face normal is added.
inline constexpr double kShortNormalSum = 0.1;

// On one side of an edge: normalise(nb + nc), with the side's face normal added where that sum is
// shorter than kShortNormalSum; 0 if all vanish. area_normal(): any positive multiple of the face
// normal, or 0; most sums do without.
template <std::invocable AreaNormal>
Vec3f midpoint_normal(const Vec3f& nb, const Vec3f& nc, const AreaNormal& area_normal) {
    Vec3 sum = Vec3{nb} + Vec3{nc};
    double squared = glm::dot(sum, sum);
    if (squared < kShortNormalSum * kShortNormalSum) {
        const Vec3 along = area_normal();
        const double area = glm::length(along);
        if (area > 0.0) sum += along / area;
        squared = glm::dot(sum, sum);
    }
    return squared > 0.0 ? Vec3f{sum / std::sqrt(squared)} : Vec3f{0.0f};
}

inline Vec3f midpoint_normal(const Vec3f& nb, const Vec3f& nc, const Vec3& area_normal) {
    return midpoint_normal(nb, nc, [&] { return area_normal; });
}

}  // namespace pectin

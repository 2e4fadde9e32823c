// The rule for a midpoint's normal.
#pragma once

#include <cmath>
#include <concepts>

#include "geometry/vec.h"

namespace pectin {

// If the sum of two unit normals is shorter than this, they are opposed (by more than 174 degrees)
// and the sum gives no reliable direction, so the face normal is added.
inline constexpr double kShortNormalSum = 0.1;

// The normal of a midpoint on one side of an edge: normalise(nb + nc), with the unit normal of that
// side's face added if the sum is shorter than kShortNormalSum; 0 if all vanish. area_normal():
// returns any positive multiple of the face normal, or 0. It is called only if it is needed.
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

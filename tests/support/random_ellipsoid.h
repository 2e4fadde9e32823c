// Random error ellipsoids, their members, and what is in them.
#pragma once

#include <cmath>

#include "geometry/error_ellipsoid.h"
#include "support/random_mesh.h"

namespace pectin::test {

// With axes up to `size`, some of which are much shorter, or zero.
inline ErrorEllipsoid random_ellipsoid(Random& random, double size) {
    ErrorEllipsoid sum;
    const int axes = random.integer(1, 4);
    for (int i = 0; i < axes; ++i) {
        const double length = random.chance(0.5) ? 1.0 : random.scale(1e-4, 1.0);
        sum = ErrorEllipsoid::sum(
            sum, ErrorEllipsoid::segment(0.25 * size * length * random.direction()));
    }
    return sum;
}

// A point E u of the boundary or inside, with S = E Eᵀ by Cholesky's factorisation.
inline Vec3 random_member(const ErrorEllipsoid& ellipsoid, Random& random) {
    const Mat3 s = ellipsoid.matrix();
    Mat3 e{0.0};
    for (int k = 0; k < 3; ++k) {
        double square = s[k][k];
        for (int i = 0; i < k; ++i) square -= e[i][k] * e[i][k];
        if (!(square > 1e-14 * s[k][k])) continue;
        e[k][k] = std::sqrt(square);
        for (int row = k + 1; row < 3; ++row) {
            double value = s[k][row];
            for (int i = 0; i < k; ++i) value -= e[i][k] * e[i][row];
            e[k][row] = value / e[k][k];
        }
    }
    const double scale = random.chance(0.7) ? 1.0 : random.uniform(0.0, 1.0);
    return (1.0 - 1e-9) * scale * (e * random.direction());
}

// |n · v| ≤ √(nᵀ S n) for all n, up to rounding: v Sinv v ≤ 1.
inline bool contains(const ErrorEllipsoid& ellipsoid, const Vec3& v) {
    if (v == Vec3{0.0}) return true;
    if (ellipsoid.is_zero()) return false;
    if (std::isinf(ellipsoid.radius())) return true;
    const Mat3 s = ellipsoid.matrix();
    return glm::dot(v, glm::inverse(s) * v) <= 1.0 + 1e-9;
}

}  // namespace pectin::test

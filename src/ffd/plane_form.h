// Quadratic forms of a plane, which bound second derivatives direction by direction.
//
// Sources: E. F. D'Azevedo, R. B. Simpson. On Optimal Interpolation Triangle Incidences. SIAM
// Journal on Scientific and Statistical Computing 10(6), 1989. J. R. Shewchuk. What Is a Good
// Linear Element? Interpolation, Conditioning, and Quality Measures. 11th International Meshing
// Roundtable, 2002.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/vec.h"

namespace pectin {

// Q(x, y) = xx x² + 2 xy x y + yy y², never below 0.
struct PlaneForm {
    double xx = 0.0, xy = 0.0, yy = 0.0;

    static PlaneForm circular(double value) { return {value, 0.0, value}; }
    double operator()(const Vec2& v) const {
        return xx * v.x * v.x + 2.0 * xy * v.x * v.y + yy * v.y * v.y;
    }
    PlaneForm& operator+=(const PlaneForm& other) {
        xx += other.xx;
        xy += other.xy;
        yy += other.yy;
        return *this;
    }
    friend PlaneForm operator*(double factor, const PlaneForm& q) {
        return {factor * q.xx, factor * q.xy, factor * q.yy};
    }
};

// The form whose matrix is the square root of that of q.
inline PlaneForm square_root(const PlaneForm& q) {
    const double trace = q.xx + q.yy;
    if (!(trace > 0.0)) return {};
    const double root = std::sqrt(std::max(0.0, q.xx * q.yy - q.xy * q.xy));
    const double scale = 1.0 / std::sqrt(trace + 2.0 * root);
    return scale * PlaneForm{q.xx + root, q.xy, q.yy + root};
}

// The sides of a triangle, as vectors of the plane.
using PlaneSides = std::array<Vec2, 3>;

// The square of the radius of the smallest circle that encloses the triangle, where q measures the
// squares of lengths. Rounded up.
inline double squared_enclosing_radius(const PlaneForm& q, const PlaneSides& sides) {
    constexpr double kRoundedUp = 1.0 + 1e-7;
    // Where the square of 4 × area is a smaller part of the fourth power of the longest side, it is
    // inexact. No circle is larger than that of an equilateral triangle with this side.
    constexpr double kNeedle = 1e-7;
    std::array<double, 3> squares{q(sides[0]), q(sides[1]), q(sides[2])};
    std::sort(squares.begin(), squares.end());
    const auto [c, b, a] = squares;
    if (b + c <= a) return 0.25 * a * kRoundedUp;
    const double area = 4.0 * b * c - (b + c - a) * (b + c - a);
    if (!(area > kNeedle * a * a)) return a / 3.0 * kRoundedUp;
    return std::min(a / 3.0, a * b * c / area) * kRoundedUp;
}

}  // namespace pectin

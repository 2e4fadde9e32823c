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

// The form whose matrix is the square root of that of q. Its error is at most 1e-7 of the root of
// the trace of q.
inline PlaneForm square_root(const PlaneForm& q) {
    const double trace = q.xx + q.yy;
    if (!(trace > 0.0)) return {};
    const PlaneForm of_trace_1{q.xx / trace, q.xy / trace, q.yy / trace};
    const double determinant = of_trace_1.xx * of_trace_1.yy - of_trace_1.xy * of_trace_1.xy;
    const double root = std::sqrt(std::max(0.0, determinant));
    return std::sqrt(trace / (1.0 + 2.0 * root)) *
           PlaneForm{of_trace_1.xx + root, of_trace_1.xy, of_trace_1.yy + root};
}

// The sides of a triangle, as vectors of the plane.
using PlaneSides = std::array<Vec2, 3>;

// The square of the radius of the smallest circle that encloses the triangle, where q measures the
// squares of lengths. Rounded up. With the squares a ≥ b ≥ c of the sides this is a/4 where the
// angle opposite a is not acute, otherwise abc / (4bc − (b + c − a)²), the circumscribed circle.
inline double squared_enclosing_radius(const PlaneForm& q, const PlaneSides& sides) {
    constexpr double kRoundedUp = 1.0 + 1e-7;
    std::array<double, 3> squares{q(sides[0]), q(sides[1]), q(sides[2])};
    std::sort(squares.begin(), squares.end());
    const auto [c, b, a] = squares;
    if (b + c <= a) return 0.25 * a * kRoundedUp;
    const double excess = b + c - a;  // at most c, so that nothing cancels below
    return a / (4.0 - (excess / b) * (excess / c)) * kRoundedUp;
}

}  // namespace pectin

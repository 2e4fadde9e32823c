// The centred uniform cubic B-spline, the basis of every deformation in pectin.
// Source: Gain & Dodgson 1999, section 2; Bartels, Beatty & Barsky, An Introduction to Splines for
// Use in Computer Graphics and Geometric Modeling, 1987.
#pragma once

#include <array>
#include <cmath>

namespace pectin {

// β(s), centred at 0 with support (−2, 2): 2/3 at 0, 1/6 at ±1, exactly 0 from ±2 on. C².
inline double basis(double s) {
    const double distance = std::abs(s);
    if (!(distance < 2.0)) return 0.0;
    const double rest = 2.0 - distance;
    if (distance >= 1.0) return rest * rest * rest / 6.0;
    return (4.0 - 3.0 * distance * distance * rest) / 6.0;
}

// β'(s), per unit of s.
inline double basis_derivative(double s) {
    const double distance = std::abs(s);
    if (!(distance < 2.0)) return 0.0;
    const double rest = 2.0 - distance;
    const double falling =
        distance >= 1.0 ? -0.5 * rest * rest : 0.5 * distance * (3.0 * distance - 4.0);
    return s < 0.0 ? -falling : falling;
}

// The four control points whose basis is not zero at a parameter: value[k] = β(u − (first + k)).
struct BasisSpan {
    int first;
    std::array<double, 4> value;
    std::array<double, 4> derivative;  // per cell
};

// `u` in cells; precondition: finite and well within the range of int.
inline BasisSpan basis_span(double u) {
    const double cell = std::floor(u);
    const double t = u - cell;
    const double s = 1.0 - t;
    return {.first = static_cast<int>(cell) - 1,
            .value = {s * s * s / 6.0, (4.0 - 3.0 * t * t * (2.0 - t)) / 6.0,
                      (4.0 - 3.0 * s * s * (2.0 - s)) / 6.0, t * t * t / 6.0},
            .derivative = {-0.5 * s * s, 0.5 * t * (3.0 * t - 4.0), 0.5 * s * (4.0 - 3.0 * s),
                           0.5 * t * t}};
}

}  // namespace pectin

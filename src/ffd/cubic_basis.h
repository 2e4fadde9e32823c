// The uniform cubic B-spline, the basis of every deformation in pectin, in value, power and
// Bernstein form.
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999: section 2; R. H. Bartels, J. C. Beatty, B. A. Barsky. An Introduction to
// Splines for Use in Computer Graphics and Geometric Modeling. Morgan Kaufmann 1987; G. Farin.
// Curves and Surfaces for CAGD. Morgan Kaufmann 2002 (Bernstein form and blossoms).
//
// The forms round differently, and the bytes of a drag depend on the order of their operations.
// The only other place that evaluates the basis is expand() in ffd/lattice_kernels.inl, which needs
// vector types that a header cannot share between instruction sets.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace pectin {

// --- Value form

// β(s), centred at 0 with support (−2, 2): 2/3 at 0, 1/6 at ±1, and exactly 0 for |s| ≥ 2. C².
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

// u: in cells. Precondition: finite and well within the range of int.
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

// --- Power form

// The coefficients of 1, t, t² and t³, or the four Bernstein coefficients.
using CubicCoefficients = std::array<double, 4>;
using CubicSegments = std::array<CubicCoefficients, 4>;

// In one cell with t in [0, 1): kPowerSegments[k] is what control point first + k contributes,
// numbered as in BasisSpan. Its segments in the order of growing s are k = 3, 2, 1, 0.
inline constexpr CubicSegments kPowerSegments{{{1.0 / 6.0, -0.5, 0.5, -1.0 / 6.0},
                                               {4.0 / 6.0, 0.0, -1.0, 0.5},
                                               {1.0 / 6.0, 0.5, 0.5, -0.5},
                                               {0.0, 0.0, 0.0, 1.0 / 6.0}}};

// --- Bernstein form

// The Bernstein coefficients on [0, 1] of a cubic in power form.
constexpr CubicCoefficients bernstein(const CubicCoefficients& p) {
    return {p[0], p[0] + p[1] / 3.0, p[0] + (2.0 * p[1] + p[2]) / 3.0, p[0] + p[1] + p[2] + p[3]};
}

inline constexpr CubicSegments kBernsteinSegments{
    bernstein(kPowerSegments[0]), bernstein(kPowerSegments[1]), bernstein(kPowerSegments[2]),
    bernstein(kPowerSegments[3])};

// The blossom (polar form) of a cubic in power form: symmetric, affine in each argument, and equal
// to the cubic where all arguments agree.
constexpr double blossom(const CubicCoefficients& p, double r, double s, double t) {
    return p[0] + p[1] * (r + s + t) / 3.0 + p[2] * (r * s + s * t + t * r) / 3.0 +
           p[3] * r * s * t;
}

// Converts the four control values of a cell to Bernstein coefficients on the part [a, b] of that
// cell: result[coefficient][k]. Coefficient i is the blossom at 3 − i times a and i times b.
constexpr CubicSegments bernstein_conversion(double a, double b) {
    const std::array<std::array<double, 3>, 4> arguments{
        {{a, a, a}, {a, a, b}, {a, b, b}, {b, b, b}}};
    CubicSegments result{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& [r, s, t] = arguments[i];
        for (std::size_t k = 0; k < 4; ++k) result[i][k] = blossom(kPowerSegments[k], r, s, t);
    }
    return result;
}

}  // namespace pectin

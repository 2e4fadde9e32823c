// Norms of the Bernstein coefficients of first and second derivatives, for DerivativeBounds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/vec.h"

namespace pectin::derivative_norms {

// What rounding may take from a bound, as a fraction of it.
inline constexpr double kRoundedUp = 1.0 + 1e-9;

// Bernstein coefficients of degree (3, 3, 3), i fastest. T is double where D is parallel to one
// direction, else Vec3.
template <typename T>
using Cube = std::array<T, 64>;

// The coefficients of the derivatives of D.
template <typename T>
struct Derivatives {
    std::array<Cube<T>, 3> first;   // along x, y and z
    std::array<Cube<T>, 6> second;  // xx, yy, zz, xy, yz, zx
};

// std::hypot() takes several times as long, to avoid an overflow that cannot happen here.
inline double root_of_squares(double x, double y) { return std::sqrt(x * x + y * y); }

inline double squared(double value) { return value * value; }
inline double squared(const Vec3& v) { return glm::dot(v, v); }
inline double product(double a, double b) { return a * b; }
inline double product(const Vec3& a, const Vec3& b) { return glm::dot(a, b); }

// The square of an upper bound of |A + B cos s + C sin s| over all s. It is attained where A, B and
// C are parallel.
template <typename T>
double squared_bound(const T& a, const T& b, const T& c) {
    const double bb = squared(b), cc = squared(c), bc = product(b, c);
    const double largest = 0.5 * (bb + cc) + root_of_squares(0.5 * (bb - cc), bc);
    return squared(a) + 2.0 * root_of_squares(product(a, b), product(a, c)) + largest;
}
inline double squared_bound(double a, double b, double c) {
    return squared(std::abs(a) + root_of_squares(b, c));
}

// The greatest singular value, by the eigenvalues of mᵀm in closed form.
inline double spectral_norm(const Mat3& m) {
    const Mat3 s = glm::transpose(m) * m;
    const double mean = (s[0][0] + s[1][1] + s[2][2]) / 3.0;
    const Mat3 d = s - mean * Mat3{1.0};
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += glm::dot(d[i], d[i]);
    const double deviation = std::sqrt(sum / 6.0);
    if (!(deviation > 0.0)) return std::sqrt(mean);
    const double r = std::clamp(0.5 * glm::determinant(d / deviation), -1.0, 1.0);
    return std::sqrt(mean + 2.0 * deviation * std::cos(std::acos(r) / 3.0)) * kRoundedUp;
}

inline Mat3 matrix(const Vec3& direction, double x, double y, double z) {
    return Mat3{x * direction, y * direction, z * direction};
}
inline Mat3 matrix(const Vec3&, const Vec3& x, const Vec3& y, const Vec3& z) {
    return Mat3{x, y, z};
}

// An upper bound of |J v|: that of the middle of the range, and the deviations from it.
template <typename T>
double stretch_over(const std::array<Cube<T>, 3>& first, const Vec3& direction) {
    std::array<T, 3> middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const T& g : first[axis]) middle[axis] += (1.0 / 64.0) * g;
    }
    double farthest = 0.0;
    for (std::size_t i = 0; i < 64; ++i) {
        farthest =
            std::max(farthest, squared(first[0][i] - middle[0]) + squared(first[1][i] - middle[1]) +
                                   squared(first[2][i] - middle[2]));
    }
    const Mat3 j = Mat3{1.0} + matrix(direction, middle[0], middle[1], middle[2]);
    return spectral_norm(j) + std::sqrt(farthest);
}

// The square of an upper bound of |(J − I − G) v| for all v with v vᵀ ≼ s. from: the columns of G.
template <typename T>
double squared_variation(const std::array<Cube<T>, 3>& first, const std::array<T, 3>& from,
                         const Mat3& s) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < 64; ++i) {
        const T x = first[0][i] - from[0], y = first[1][i] - from[1], z = first[2][i] - from[2];
        const double on = s[0][0] * squared(x) + s[1][1] * squared(y) + s[2][2] * squared(z);
        greatest =
            std::max(greatest, on + 2.0 * (s[0][1] * product(x, y) + s[0][2] * product(x, z) +
                                           s[1][2] * product(y, z)));
    }
    return greatest;
}

inline double component(double value, int) { return value; }
inline double component(const Vec3& v, int axis) { return v[axis]; }

// The square of an upper bound of |D²F(v, v)| for all v with v vᵀ ≼ s: the sum of tr(H s H s) over
// the Hessians H of the components.
template <typename T>
double squared_bend_within(const std::array<Cube<T>, 6>& second, const Mat3& s) {
    constexpr int kComponents = sizeof(T) / sizeof(double);
    double greatest = 0.0;
    for (std::size_t i = 0; i < 64; ++i) {
        double sum = 0.0;
        for (int c = 0; c < kComponents; ++c) {
            const auto h = [&](std::size_t e) { return component(second[e][i], c); };
            const Mat3 m = Mat3{{h(0), h(3), h(5)}, {h(3), h(1), h(4)}, {h(5), h(4), h(2)}} * s;
            const Mat3 rows = glm::transpose(m);
            for (int k = 0; k < 3; ++k) sum += glm::dot(m[k], rows[k]);
        }
        greatest = std::max(greatest, sum);
    }
    return greatest;
}

// The square of an upper bound of |D²F(u, v)|, by the Frobenius norm.
template <typename T>
double squared_bend_any(const std::array<Cube<T>, 6>& second) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < 64; ++i) {
        double sum = 0.0;
        for (std::size_t e = 0; e < 6; ++e) sum += (e < 3 ? 1.0 : 2.0) * squared(second[e][i]);
        greatest = std::max(greatest, sum);
    }
    return greatest;
}

// The square of the greatest length of cos t · p + sin t · q.
inline double squared_radius(const Vec3& p, const Vec3& q) {
    const double pp = squared(p), qq = squared(q);
    return 0.5 * (pp + qq) + root_of_squares(0.5 * (pp - qq), glm::dot(p, q));
}

}  // namespace pectin::derivative_norms

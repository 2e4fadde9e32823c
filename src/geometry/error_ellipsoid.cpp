#include "geometry/error_ellipsoid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pectin {
namespace {

// What is added to the diagonal of S before it is rounded to floats: as a fraction of its trace,
// four times what rounding may take, and the rounding of numbers near zero.
constexpr double kFloatRounding = 0x1p-22;
constexpr double kLeast = 4.0 * static_cast<double>(std::numeric_limits<float>::denorm_min());
// A trace from which on nothing is said about the error.
constexpr double kMost = 0.25 * static_cast<double>(std::numeric_limits<float>::max());
// The rounding of a few operations in double, relative to the traces of their operands.
constexpr double kRounding = 1e-13;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double trace_of(const Mat3& m) { return m[0][0] + m[1][1] + m[2][2]; }

// The eigenvalues of a symmetric matrix, and unit eigenvectors, by rotations of Jacobi. They do not
// depend on the signs of the axes.
struct Eigen3 {
    Vec3 values{0.0};
    Mat3 vectors{1.0};
};

Eigen3 eigen_decomposition(Mat3 m) {
    constexpr int kMostSweeps = 12;
    Eigen3 result;
    Mat3& v = result.vectors;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        const double beside = std::abs(m[1][0]) + std::abs(m[2][0]) + std::abs(m[2][1]);
        const double on = std::abs(m[0][0]) + std::abs(m[1][1]) + std::abs(m[2][2]);
        if (!(beside > 1e-17 * on)) break;
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (m[p][q] == 0.0) continue;
                const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
                const double t =
                    (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::hypot(theta, 1.0));
                const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
                for (int i = 0; i < 3; ++i) {  // columns
                    const double a = m[p][i], b = m[q][i];
                    m[p][i] = c * a - s * b;
                    m[q][i] = s * a + c * b;
                }
                for (int i = 0; i < 3; ++i) {  // rows
                    const double a = m[i][p], b = m[i][q];
                    m[i][p] = c * a - s * b;
                    m[i][q] = s * a + c * b;
                }
                for (int i = 0; i < 3; ++i) {
                    const double a = v[p][i], b = v[q][i];
                    v[p][i] = c * a - s * b;
                    v[q][i] = s * a + c * b;
                }
            }
        }
    }
    result.values = {m[0][0], m[1][1], m[2][2]};
    return result;
}

// Whether Cholesky's factorisation exists.
bool is_positive_definite(const Mat3& m) {
    const double a = m[0][0];
    if (!(a > 0.0)) return false;
    const double b = m[1][1] - m[0][1] * m[0][1] / a;
    if (!(b > 0.0)) return false;
    const double across = m[1][2] - m[0][1] * m[0][2] / a;
    return m[2][2] - m[0][2] * m[0][2] / a - across * across / b > 0.0;
}

}  // namespace

// Never zero alone.
ErrorEllipsoid ErrorEllipsoid::rounded_up(const Mat3& s) {
    const double trace = trace_of(s);
    if (!(trace < kMost)) return all_of_space();
    const double slack = kFloatRounding * trace + kLeast;
    ErrorEllipsoid result;
    result.entries_ = {static_cast<float>(s[0][0] + slack), static_cast<float>(s[1][1] + slack),
                       static_cast<float>(s[2][2] + slack), static_cast<float>(s[1][0]),
                       static_cast<float>(s[2][0]),         static_cast<float>(s[2][1])};
    return result;
}

ErrorEllipsoid ErrorEllipsoid::all_of_space() {
    constexpr float kAll = std::numeric_limits<float>::infinity();
    ErrorEllipsoid result;
    result.entries_ = {kAll, kAll, kAll, 0.0f, 0.0f, 0.0f};
    return result;
}

bool ErrorEllipsoid::is_all_of_space() const { return std::isinf(entries_[0]); }

ErrorEllipsoid ErrorEllipsoid::ball(double radius) {
    return radius == 0.0 ? ErrorEllipsoid{} : rounded_up(Mat3{radius * radius});
}

ErrorEllipsoid ErrorEllipsoid::segment(const Vec3& v) {
    return v == Vec3{0.0} ? ErrorEllipsoid{} : rounded_up(glm::outerProduct(v, v));
}

Mat3 ErrorEllipsoid::matrix() const {
    std::array<double, 6> e;
    std::ranges::copy(entries_, e.begin());
    return {{e[0], e[3], e[4]}, {e[3], e[1], e[5]}, {e[4], e[5], e[2]}};
}

double ErrorEllipsoid::trace() const { return trace_of(matrix()); }

double ErrorEllipsoid::rough_radius() const { return std::sqrt(trace() * (1.0 + kRounding)); }

double ErrorEllipsoid::radius() const {
    if (is_zero()) return 0.0;
    if (is_all_of_space()) return kInfinite;
    const Vec3 squares = eigen_decomposition(matrix()).values;
    const double largest = std::max({squares.x, squares.y, squares.z});
    return std::sqrt(largest * (1.0 + kRounding));
}

// (1 + 1/p) A + (1 + p) B contains the sum for each p > 0. This p makes the trace least.
ErrorEllipsoid ErrorEllipsoid::sum(const ErrorEllipsoid& a, const ErrorEllipsoid& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    if (a.is_all_of_space() || b.is_all_of_space()) return all_of_space();
    const double p = std::sqrt(a.trace()), q = std::sqrt(b.trace());
    return rounded_up((p + q) / p * a.matrix() + (p + q) / q * b.matrix());
}

ErrorEllipsoid ErrorEllipsoid::image(const Mat3& jacobian, const ErrorEllipsoid& a) {
    if (a.is_zero() || a.is_all_of_space()) return a;
    double size = 0.0;
    for (int i = 0; i < 3; ++i) size += glm::dot(jacobian[i], jacobian[i]);
    return rounded_up(jacobian * a.matrix() * glm::transpose(jacobian) +
                      Mat3{kRounding * size * a.trace()});
}

bool ErrorEllipsoid::contains(const ErrorEllipsoid& a) const {
    return is_positive_definite(matrix() - a.matrix() - Mat3{kRounding * trace()});
}

// (A + B + |A - B|) / 2, which is A and the positive part of B - A.
ErrorEllipsoid ErrorEllipsoid::hull(const ErrorEllipsoid& a, const ErrorEllipsoid& b) {
    if (a == b || b.is_zero() || a.is_all_of_space()) return a;
    if (a.is_zero() || b.is_all_of_space()) return b;
    if (a.contains(b)) return a;
    if (b.contains(a)) return b;
    const auto [values, vectors] = eigen_decomposition(a.matrix() - b.matrix());
    Mat3 both = a.matrix() + b.matrix();
    for (int i = 0; i < 3; ++i) {
        both += std::abs(values[i]) * glm::outerProduct(vectors[i], vectors[i]);
    }
    return rounded_up(0.5 * both);
}

}  // namespace pectin

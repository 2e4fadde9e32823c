#include "geometry/error_ellipsoid.h"

#include <Eigen/Eigenvalues>
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

using EigenSolver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

Eigen::Matrix3d as_eigen(const Mat3& symmetric) {
    return Eigen::Map<const Eigen::Matrix3d>(&symmetric[0][0]);
}

// The matrix with the absolute values of the eigenvalues. Bit for bit the same for the mirror image
// in a plane across an axis, since changes of sign are not rounded.
Mat3 absolute(const Mat3& symmetric) {
    const EigenSolver solver(as_eigen(symmetric));
    Mat3 sum{0.0};
    for (int i = 0; i < 3; ++i) {
        const Vec3 v{solver.eigenvectors()(0, i), solver.eigenvectors()(1, i),
                     solver.eigenvectors()(2, i)};
        sum += std::abs(solver.eigenvalues()(i)) * glm::outerProduct(v, v);
    }
    return sum;
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
    const double largest =
        EigenSolver(as_eigen(matrix()), Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
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
    if (b.entries_ < a.entries_) return hull(b, a);
    return rounded_up(0.5 * (a.matrix() + b.matrix() + absolute(a.matrix() - b.matrix())));
}

}  // namespace pectin

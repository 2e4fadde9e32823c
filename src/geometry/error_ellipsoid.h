// A set that contains all error vectors of a face: an ellipsoid about zero.
//
// Source: A. Kurzhanski, I. Valyi. Ellipsoidal Calculus for Estimation and Control. Birkhauser 1997
// (outer ellipsoids of sums, of least trace).
//
// The set is {v : v v^T <= S} with a symmetric positive semidefinite matrix S, that is, all v with
// |n . v| <= sqrt(n^T S n) for each n. S may be singular: of an error along a line it has rank one.
// Unlike a length, it is transported by a Jacobian and not by the norm of one, so an error across
// the direction in which a deformation stretches does not grow.
//
// S is stored in floats. Each result is rounded so that the set does not shrink; what is handed on
// does not change.
#pragma once

#include <array>

#include "geometry/vec.h"

namespace pectin {

class ErrorEllipsoid {
  public:
    ErrorEllipsoid() = default;  // zero alone
    // All vectors that are no longer than the radius; all of space if that is infinite.
    static ErrorEllipsoid ball(double radius);
    // The segment from -v to v.
    static ErrorEllipsoid segment(const Vec3& v);

    bool is_zero() const { return *this == ErrorEllipsoid{}; }
    // The length of the longest vector, or somewhat more. Cost: some hundred operations.
    double radius() const;
    // At least radius(), at most sqrt(3) times that. Cost: O(1), fast.
    double rough_radius() const;
    Mat3 matrix() const;  // S, in squared world units

    // Ellipsoids that contain {u + v : u in a, v in b}, {J v : v in a}, and both a and b. The last
    // one is a if b is the same or lies in it, to the byte. The order of a and b does not count.
    static ErrorEllipsoid sum(const ErrorEllipsoid& a, const ErrorEllipsoid& b);
    static ErrorEllipsoid image(const Mat3& jacobian, const ErrorEllipsoid& a);
    static ErrorEllipsoid hull(const ErrorEllipsoid& a, const ErrorEllipsoid& b);

    // The diagonal of S, and its entries xy, xz and yz.
    const std::array<float, 6>& entries() const { return entries_; }
    bool operator==(const ErrorEllipsoid&) const = default;

  private:
    static ErrorEllipsoid rounded_up(const Mat3& s);
    static ErrorEllipsoid all_of_space();
    bool is_all_of_space() const;
    double trace() const;
    bool contains(const ErrorEllipsoid& a) const;  // false may mean that it is not sure

    std::array<float, 6> entries_{};
};

}  // namespace pectin

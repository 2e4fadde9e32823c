// A weight of a drag as a tricubic spline with explicit coefficients.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ffd/lattice.h"

namespace pectin {

// w(x) = Σ c_ijk β(u − i) β(v − j) β(w − k) with one coefficient for each deformable control point.
class WeightSpline {
  public:
    // coefficients: control_count of the lattice, in the order of control_index.
    WeightSpline(const Lattice& lattice, std::span<const double> coefficients);

    struct Value {
        double w = 0.0;
        Vec3 gradient{0.0};  // per world unit
    };
    // Precondition: the lattice influences x. Cost: about 200 multiplications.
    Value at(const Vec3& x) const;

    double coefficient(const IVec3& control) const { return padded_[index(control)]; }
    // Upper bounds of |w| and |∇w| over all of space, by the convex hull property of B-splines: the
    // derivative along an axis is a spline of degree 2 whose coefficients are the differences of
    // neighbouring coefficients.
    double weight_bound() const { return weight_bound_; }
    double gradient_bound() const { return gradient_bound_; }

  private:
    // A frame of zeros, so that the 64 coefficients around any point of the zone exist. Two layers
    // follow from the influenced zone, one from the width of the basis, and one from rounding.
    static constexpr int kPadding = 4;

    std::size_t index(const IVec3& control) const {
        return static_cast<std::size_t>(control.x + kPadding) +
               row_ * static_cast<std::size_t>(control.y + kPadding) +
               layer_ * static_cast<std::size_t>(control.z + kPadding);
    }
    void find_bounds();

    Lattice lattice_;
    std::size_t row_, layer_;  // distances in `padded_` of neighbours along y and z
    std::vector<double> padded_;
    double weight_bound_ = 0.0, gradient_bound_ = 0.0;
};

}  // namespace pectin

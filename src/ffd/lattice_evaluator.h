// A lattice field laid out to be evaluated at many points: the 4 × 4 × 4 sum, streaming.
// Source: Gain & Dodgson 1999, equations 1–7.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ffd/lattice_field.h"

namespace pectin {

// Holds the control points with the static ones about them, so that no point meets a border. What
// it gives agrees with LatticeField to rounding (its sums go axis by axis), and with itself to the
// bit, however many points are asked for at once.
class LatticeEvaluator {
  public:
    // Cost: O(control points); 24 bytes each.
    explicit LatticeEvaluator(const LatticeField& field);

    // to: n_points, x + D(x). On the border of the influenced zone and outside x itself, to the
    // bit.
    void displace(std::span<const Vec3> points, std::span<Vec3> to) const;

    // The same, and the covariant normals at the points: normalise(cof(J)·n), zero where that has
    // no direction, n itself outside. normals, turned: n_points.
    void transform(std::span<const Vec3> points, std::span<const Vec3f> normals, std::span<Vec3> to,
                   std::span<Vec3f> turned) const;

    std::size_t memory_bytes() const;

  private:
    Lattice lattice_;
    Box zone_;
    std::ptrdiff_t row_ = 0, layer_ = 0;  // strides of j and k
    std::vector<double> x_, y_, z_;       // displacements from (−3, −3, −3) on, i fastest
};

}  // namespace pectin

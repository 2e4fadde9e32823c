// A lattice field laid out to be evaluated at many points: the 4 × 4 × 4 sum, streaming.
// Source: Gain & Dodgson 1999, equations 1–7.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ffd/lattice_field.h"
#include "ffd/vectorised.h"

namespace pectin {

// Holds the control points with the static ones about them, so that no point meets a border.
//
// All in double: displacements agree with LatticeField's to some roundings of the greatest one,
// normals to those of float. A point's result depends on that point alone, to the bit: not on how
// many are asked for at once, which of them stands beside it, with or without normals, nor on the
// machine. Cost: about 200 instructions a point with AVX2, 420 with a normal.
class LatticeEvaluator {
  public:
    // Vectors up to the widest that the machine has (no wider than AVX2's are used: wider ones gain
    // nothing here); the results are the same.
    // Cost: O(control points); 24 bytes each.
    explicit LatticeEvaluator(const LatticeField& field, Vectors vectors = widest_vectors());

    // Takes over the displacements of a field on the same lattice. Cost: O(control points).
    void update(const LatticeField& field);

    // to: n_points, x + D(x). On the border of the influenced zone and outside x itself, to the
    // bit.
    void displace(std::span<const Vec3> points, std::span<Vec3> to) const;

    // The same, and the covariant normals at the points: normalise(cof(J)·n), zero where that has
    // no direction, n itself outside and where J is the identity. normals, turned: n_points.
    void transform(std::span<const Vec3> points, std::span<const Vec3f> normals, std::span<Vec3> to,
                   std::span<Vec3f> transformed) const;

    std::size_t memory_bytes() const;

  private:
    Lattice lattice_;
    Vectors vectors_;
    IVec3 size_;                     // control points held, static ones included
    std::vector<double> x_, y_, z_;  // displacements from (−3, −3, −3) on, i fastest
};

}  // namespace pectin

// Evaluates a lattice field at many points: the 4 × 4 × 4 sum as a streaming pass.
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999: equations 1 and 3–7.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ffd/lattice_field.h"
#include "ffd/vectorised.h"

namespace pectin {

// Holds the deformable control points and the static ones around them, so that no sum has to test
// for a border.
//
// Computes in double. Displacements equal those of LatticeField up to some rounding errors of the
// largest one, and normals up to those of float. The result of a point depends bit for bit on that
// point alone: not on the number of points in a call, on the points beside it, on whether normals
// are computed, or on the machine. Cost: about 200 instructions for a point with AVX2, and 420 with
// a normal.
class LatticeEvaluator {
  public:
    // vectors: an instruction set that the machine has. The results do not depend on it. Vectors
    // wider than those of AVX2 gain nothing here and are not used. Cost: O(control points), 24
    // bytes for each.
    explicit LatticeEvaluator(const LatticeField& field, Vectors vectors = widest_vectors());

    // Copies the displacements of a field on the same lattice. Cost: O(control points).
    void update(const LatticeField& field);

    // to: n_points, x + D(x). On the border of the influenced zone and outside it is x bit for
    // bit.
    void displace(std::span<const Vec3> points, std::span<Vec3> to) const;

    // The same, and equation 3: the covariant normals normalise(cof(J)·n) at the points. They are
    // zero where the image has no direction, and n bit for bit outside the zone and where J is the
    // identity. normals, transformed: n_points.
    void transform(std::span<const Vec3> points, std::span<const Vec3f> normals, std::span<Vec3> to,
                   std::span<Vec3f> transformed) const;

    std::size_t memory_bytes() const;

  private:
    Lattice lattice_;
    Vectors vectors_;
    IVec3 size_;                     // of the grid of control points, with the static ones
    std::vector<double> x_, y_, z_;  // displacements from (−3, −3, −3) on, i fastest
};

}  // namespace pectin

// The deformation by a displaced lattice, evaluated plainly: the reference for every faster path,
// and the field of control points moved by hand.
// Source: Gain & Dodgson 1999, equations 1–7.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "ffd/lattice.h"

namespace pectin {

class LatticeField {
  public:
    // displacements: control_count of the lattice, in the order of control_index, world space.
    LatticeField(const Lattice& lattice, std::vector<Vec3> displacements);

    const Lattice& lattice() const { return lattice_; }
    std::span<const Vec3> displacements() const { return displacements_; }
    std::span<Vec3> displacements() { return displacements_; }

    // D(x) = Σ β(u − i) β(v − j) β(w − k) ΔP_ijk, world space (equation 1, by linear precision).
    // Exactly zero on the border of the influenced zone and outside. 64 terms.
    Vec3 displacement(const Vec3& x) const;

    // J = ∂(x + D)/∂x in world units (equations 4–7; the 1/cell the paper drops differs per axis
    // and stays). Exactly the identity on the border of the influenced zone and outside.
    Mat3 jacobian(const Vec3& x) const;

  private:
    Lattice lattice_;
    std::vector<Vec3> displacements_;
};

// Equation 3: normals are covariant, normalise(cof(J)·n) with cof(J) = adj(J)ᵀ, turning with the
// surface even where space folds. The identity gives back the very same n; a zero n, or one whose
// image has no direction, gives zero.
Vec3f covariant(const Mat3& jacobian, const Vec3f& n);

// Equation 3: tangents are contravariant, J·t.
Vec3 contravariant(const Mat3& jacobian, const Vec3& t);

}  // namespace pectin

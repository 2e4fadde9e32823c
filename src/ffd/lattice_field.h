// The deformation by a displaced lattice, evaluated directly. It is the reference for all faster
// paths, and the field of control points that are moved by hand.
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999: equations 1 and 3–7 (2 becomes 3 for a lattice along the world's axes).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ffd/drag_weight.h"
#include "ffd/lattice.h"

namespace pectin {

class LatticeField {
  public:
    // displacements: control_count of the lattice, in the order of control_index, world space.
    LatticeField(const Lattice& lattice, std::vector<Vec3> displacements);

    const Lattice& lattice() const { return lattice_; }
    std::span<const Vec3> displacements() const { return displacements_; }
    std::span<Vec3> displacements() { return displacements_; }

    // D(x) = Σ β(u − i) β(v − j) β(w − k) ΔP_ijk in world space: equation 1, with linear precision.
    // Exactly zero on the border of the influenced zone and outside. Cost: 64 terms.
    Vec3 displacement(const Vec3& x) const;

    // J = ∂(x + D)/∂x in world units: equations 4–7 with the factors 1/cell, which the paper omits
    // and which differ between the axes. Exactly the identity on the border of the influenced zone
    // and outside.
    Mat3 jacobian(const Vec3& x) const;

  private:
    Lattice lattice_;
    std::vector<Vec3> displacements_;
};

// Equation 3: normals are covariant, normalise(cof(J)·n) with cof(J) = adj(J)ᵀ. The image stays on
// the same side of the surface even where space folds. The identity returns n bit for bit. A zero n
// gives zero, and so does an n whose image has no direction.
Vec3f covariant(const Mat3& jacobian, const Vec3f& n);

// Equation 3: tangents are contravariant, J·t.
Vec3 contravariant(const Mat3& jacobian, const Vec3& t);

// --- What every deformation supplies; ffd/deformation.h explains each function.

inline const Lattice& lattice_of(const LatticeField& field) { return field.lattice(); }
inline std::span<const Vec3> displacements_of(const LatticeField& field) {
    return field.displacements();
}
inline std::span<Vec3> displacements_of(LatticeField& field) { return field.displacements(); }
std::vector<Box> zones_of(const LatticeField& field);
inline double smallest_feature_extent(const LatticeField& field) {
    return field.lattice().smallest_cell_extent();
}
std::vector<LatticeField> merged_lattices(const LatticeField& field);

// It has no weights: an embedding would need 64 of them for each vertex.
inline std::size_t weight_count(const LatticeField&) { return 0; }
inline void weights_at(const LatticeField&, const Vec3&, std::span<DragWeight>) {}
inline Vec3 image(const LatticeField& field, const Vec3& x, std::span<const DragWeight>) {
    return x + field.displacement(x);
}
inline Mat3 jacobian(const LatticeField& field, const Vec3& x, std::span<const DragWeight>) {
    return field.jacobian(x);
}
inline double jacobian_determinant(const LatticeField& field, const Vec3& x,
                                   std::span<const DragWeight>) {
    return glm::determinant(field.jacobian(x));
}
inline Vec3f covariant_normal(const LatticeField& field, const Vec3& x, std::span<const DragWeight>,
                              const Vec3f& n) {
    return covariant(field.jacobian(x), n);
}

double reach_bound(const LatticeField& field);      // not known
double lipschitz_bound(const LatticeField& field);  // not known
double injective_limit(const LatticeField& field, double most = 1.0);

}  // namespace pectin

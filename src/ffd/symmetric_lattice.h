// The symmetric deformation by a displaced lattice and its mirror image, evaluated directly. It is
// the form of a symmetric drag that moves many points.
#pragma once

#include <span>
#include <vector>

#include "ffd/lattice_field.h"
#include "ffd/symmetry.h"

namespace pectin {

// The field is D(x) = D_L(x) + M D_L(Mx), where D_L is the field of the lattice and M the
// reflection in the plane. A point and its image are moved and bent as mirror images of each other
// (bit for bit if reflecting an image gives the point again, as in planes through the origin), and
// points of the plane stay on it. Cost of an evaluation: that of two lattice fields, however many
// points are dragged.
struct SymmetricLattice {
    LatticeField field;
    MirrorPlane plane;

    Vec3 displacement(const Vec3& x) const;
    Mat3 jacobian(const Vec3& x) const;
};

// --- What every deformation supplies; ffd/deformation.h explains each function.

inline const Lattice& lattice_of(const SymmetricLattice& lattice) {
    return lattice.field.lattice();
}
inline std::span<const Vec3> displacements_of(const SymmetricLattice& lattice) {
    return lattice.field.displacements();
}
inline std::span<Vec3> displacements_of(SymmetricLattice& lattice) {
    return lattice.field.displacements();
}
std::vector<Box> zones_of(const SymmetricLattice& lattice);
inline double smallest_feature_extent(const SymmetricLattice& lattice) {
    return lattice.field.lattice().smallest_cell_extent();
}
std::vector<LatticeField> merged_lattices(const SymmetricLattice& lattice);

inline std::size_t weight_count(const SymmetricLattice&) { return 0; }
inline void weights_at(const SymmetricLattice&, const Vec3&, std::span<DragWeight>) {}
inline Vec3 image(const SymmetricLattice& lattice, const Vec3& x, std::span<const DragWeight>) {
    return x + lattice.displacement(x);
}
inline Mat3 jacobian(const SymmetricLattice& lattice, const Vec3& x, std::span<const DragWeight>) {
    return lattice.jacobian(x);
}
inline double jacobian_determinant(const SymmetricLattice& lattice, const Vec3& x,
                                   std::span<const DragWeight>) {
    return glm::determinant(lattice.jacobian(x));
}
inline Vec3f covariant_normal(const SymmetricLattice& lattice, const Vec3& x,
                              std::span<const DragWeight>, const Vec3f& n) {
    return covariant(lattice.jacobian(x), n);
}

double reach_bound(const SymmetricLattice& lattice);      // not known
double lipschitz_bound(const SymmetricLattice& lattice);  // not known
double injective_limit(const SymmetricLattice& lattice, double most = 1.0);

}  // namespace pectin

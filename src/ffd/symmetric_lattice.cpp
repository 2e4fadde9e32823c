#include "ffd/symmetric_lattice.h"

#include <limits>

#include "ffd/injectivity.h"

namespace pectin {

Vec3 SymmetricLattice::displacement(const Vec3& x) const {
    return field.displacement(x) + plane.image_of_vector(field.displacement(plane.image(x)));
}

// Both Jacobians contain the identity, which counts once. They are added first, so that the sum is
// the same for a point and its image.
Mat3 SymmetricLattice::jacobian(const Vec3& x) const {
    const Mat3 both = field.jacobian(x) + plane.image_of_jacobian(field.jacobian(plane.image(x)));
    return both - Mat3{1.0};
}

std::vector<Box> zones_of(const SymmetricLattice& lattice) {
    return symmetric_zones(lattice.plane, lattice.field.lattice());
}

std::vector<LatticeField> merged_lattices(const SymmetricLattice& lattice) {
    return {lattice.field, mirror_image(lattice.plane, lattice.field)};
}

double reach_bound(const SymmetricLattice&) { return std::numeric_limits<double>::infinity(); }

double lipschitz_bound(const SymmetricLattice&) { return std::numeric_limits<double>::infinity(); }

double injective_limit(const SymmetricLattice& lattice, double most) {
    return injective_limit(merged_lattices(lattice), most);
}

}  // namespace pectin

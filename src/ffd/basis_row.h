// One row of the constraint matrix: the basis values of all control points at a constrained point.
// Source: W. M. Hsu, J. F. Hughes, H. Kaufman. Direct Manipulation of Free-Form Deformations.
// SIGGRAPH 1992: section 3.
#pragma once

#include <array>

#include "ffd/lattice.h"

namespace pectin {

// The row b of a constraint, scaled to unit length. It is a tensor product of three short
// sequences: b_ijk / |b| = coefficient[0][i − first[0]] · coefficient[1][j − first[1]] ·
// coefficient[2][…]. The coefficients of control points that are not deformable are zero.
struct BasisRow {
    std::array<int, 3> first{};
    std::array<std::array<double, 4>, 3> coefficient{};
    double length = 0.0;  // |b|; 0 where no deformable control point reaches the point
};

// Precondition: the lattice influences x.
BasisRow basis_row(const Lattice& lattice, const Vec3& x);

// The row of ∂b/∂x[along], per world unit. Its length is 0 if no displacement of the lattice has
// such a derivative. Precondition: the lattice influences x.
BasisRow basis_derivative_row(const Lattice& lattice, const Vec3& x, int along);

// The scalar product of two rows of unit length, which is an entry of the normalised Gram matrix.
double dot(const BasisRow& a, const BasisRow& b);

// The largest displacement of any control point if only the point of this row is constrained and
// moves by a unit vector: max b / |b|².
double control_gain(const BasisRow& row);

}  // namespace pectin

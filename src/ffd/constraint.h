// The constraints that a drag sets on the lattice. Each is one row of the linear system.
// Source: W. M. Hsu, J. F. Hughes, H. Kaufman. Direct Manipulation of Free-Form Deformations.
// SIGGRAPH 1992: section 3, and section 3.3 for derivatives.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "ffd/basis_row.h"
#include "ffd/symmetry.h"

namespace pectin {

// Identifies a constraint: the point at which a displacement or its derivative is prescribed, and
// with symmetry the components that it applies to.
struct ConstraintKey {
    Vec3 point{0.0};
    int along = -1;       // the axis of the derivative, or −1 for the displacement itself
    double parity = 1.0;  // −1 for the component across the mirror plane; see symmetry.h
    bool operator==(const ConstraintKey&) const = default;
};

// A row scaled to unit length: Σ factor · row over its terms. There are two terms if the mirror
// image of the point also lies in the lattice, and otherwise one.
struct Constraint {
    struct Term {
        BasisRow row;
        double factor = 1.0;
    };
    ConstraintKey key;
    std::array<Term, 2> terms{};
    std::size_t term_count = 0;
    double length = 0.0;  // before the scaling; 0 if the lattice cannot meet the constraint

    // The largest displacement of any control point if this constraint alone prescribes 1.
    double control_gain() const;
};

Constraint make_constraint(const Lattice& lattice, const std::optional<MirrorPlane>& plane,
                           const ConstraintKey& key);

// An entry of the normalised Gram matrix. It is 0 between different parities, which are
// independent.
double dot(const Constraint& a, const Constraint& b);

}  // namespace pectin

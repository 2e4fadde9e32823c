// What a drag asks of the lattice: each constraint one row of the linear system.
// Source: Hsu, Hughes & Kaufman 1992, section 3; its section 3.3 for derivatives.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "ffd/basis_row.h"
#include "ffd/symmetry.h"

namespace pectin {

// Where a displacement is prescribed, or its derivative; with symmetry, of which components.
struct ConstraintKey {
    Vec3 point{0.0};
    int along = -1;       // the axis of the derivative, −1 for the displacement itself
    double parity = 1.0;  // −1: the component across the mirror plane; see symmetry.h
    bool operator==(const ConstraintKey&) const = default;
};

// A row scaled to unit length: Σ factor · row over one term, or two where the mirror image of the
// point lies in the lattice, too.
struct Constraint {
    struct Term {
        BasisRow row;
        double factor = 1.0;
    };
    ConstraintKey key;
    std::array<Term, 2> terms{};
    std::size_t term_count = 0;
    double length = 0.0;  // before the scaling; 0 where the lattice cannot bring it about

    // The largest displacement of a control point where this constraint alone asks for 1.
    double control_gain() const;
};

Constraint make_constraint(const Lattice& lattice, const std::optional<MirrorPlane>& plane,
                           const ConstraintKey& key);

// An entry of the normalised Gram matrix; 0 between different parities, which do not meet.
double dot(const Constraint& a, const Constraint& b);

}  // namespace pectin

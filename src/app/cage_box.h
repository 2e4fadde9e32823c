// A cage as the box from which it was fitted.
#pragma once

#include "ffd/lattice.h"

namespace pectin {

// The box from the first to the last control point along each axis, without the margins. Along an
// axis with one control point, it extends by a cell to both sides. fit_lattice() is the inverse.
inline Box cage_box(const Lattice& cage) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const int gaps = cage.counts()[axis] - 1;
        const double beyond = gaps == 0 ? cage.cell[axis] : 0.0;
        const double first = cage.origin[axis] + cage.margin[axis] * cage.cell[axis];
        box.min[axis] = first - beyond;
        box.max[axis] = first + gaps * cage.cell[axis] + beyond;
    }
    return box;
}

}  // namespace pectin

// A cage as a person sets it: a box with control points in it.
#pragma once

#include "ffd/lattice.h"

namespace pectin {

// From the first to the last control point of each axis without the margins; where there is only
// one, a cell to both of its sides. fit_lattice() is the inverse.
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

// A cage as a person sets it: a box with control points in it.
#pragma once

#include "ffd/lattice.h"

namespace pectin {

// From the first to the last deformable control point of each axis; where there is but one, a cell
// to both of its sides. fit_lattice() is the way back.
inline Box cage_box(const Lattice& cage) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const int gaps = cage.deformable[axis] - 1;
        const double margin = gaps == 0 ? cage.cell[axis] : 0.0;
        box.min[axis] = cage.origin[axis] - margin;
        box.max[axis] = cage.origin[axis] + gaps * cage.cell[axis] + margin;
    }
    return box;
}

}  // namespace pectin

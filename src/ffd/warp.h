// Drag fields one after the other: the warp of space that a gesture applies.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "ffd/drag_field.h"

namespace pectin {

// Step k acts on where the steps before it have brought a point; each has a lattice of its own.
// A plain drag is one step.
struct Warp {
    struct Step {
        DragField field;
        std::vector<Vec3> displacements;  // field.move_count()
    };
    std::vector<Step> steps;

    // A box outside which nothing moves: that of all influenced zones.
    Box zone() const {
        Box box;
        for (const Step& step : steps) box.include(step.field.lattice().influenced_zone());
        return box;
    }
    // The smallest cell extent of its lattices; infinite without steps.
    double smallest_cell_extent() const {
        double extent = std::numeric_limits<double>::infinity();
        for (const Step& step : steps) {
            extent = std::min(extent, step.field.lattice().smallest_cell_extent());
        }
        return extent;
    }
};

}  // namespace pectin

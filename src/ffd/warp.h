// A warp: deformations applied one after another, which is what a gesture does to space.
#pragma once

#include <vector>

#include "ffd/deformation.h"

namespace pectin {

// Step k acts on a point where the steps before it have taken that point, and each step has a
// lattice of its own. A plain drag is one DragStep; control points moved by hand are one
// LatticeField.
struct Warp {
    std::vector<Deformation> steps;
    // Whether each step moves the middle of a zone by at most about a cell, and other points the
    // less the farther they are from it. Where mirrored zones overlap, both move a point.
    bool moves_middles_most = false;

    // Boxes outside which nothing moves: the zones of all steps, without duplicates.
    std::vector<Box> zones() const;
    // The box around all of these.
    Box zone() const;
    // The smallest feature extent of all steps; infinite if there are none.
    double smallest_feature_extent() const;
};

}  // namespace pectin

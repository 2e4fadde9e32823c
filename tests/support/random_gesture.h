// Random deformations of space of every kind that a gesture can have.
#pragma once

#include <cstddef>
#include <string>

#include "ffd/warp.h"
#include "mesh/tri_mesh.h"
#include "support/random_mesh.h"

namespace pectin::test {

struct RandomGesture {
    Warp warp;
    std::string description;
};

// A drag with a brush or a cage, of one handle or of several, with twists and scales, pins and
// symmetry, in one step or fold-free in several; or control points that are moved by hand.
RandomGesture random_gesture(const TriMesh& mesh, Random& random);

}  // namespace pectin::test

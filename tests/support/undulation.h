// The paper's figure 4: edges that undulate between ends whose normals stay parallel.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, point 1 and figure 4.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "ffd/lattice_field.h"
#include "ffd/warp.h"

namespace pectin::test {

inline constexpr double kUndulationCell = 0.125;  // along x, the smallest extent

// Waves along x on a square of side 2 around the origin in the plane y = 0. There are whole waves
// in each unit of length, so that crests lie where x is -1, 0 or 1. By symmetry nothing is tilted
// there, and a mesh whose vertices have such x has parallel normals. With 2 waves, crests lie also
// in the middle of edges of unit length. height: of the control points of a crest.
inline Warp undulation(int waves, double height) {
    const Lattice lattice{.origin = {-2.0, -2.0, -3.0},
                          .cell = {kUndulationCell, 1.0, 1.0},
                          .deformable = {33, 5, 7}};
    std::vector<Vec3> displacements(lattice.control_count());
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                const IVec3 control{i, j, k};
                const double phase = 2.0 * std::numbers::pi * waves * lattice.rest(control).x;
                displacements[lattice.control_index(control)] = {0.0, height * std::cos(phase),
                                                                 0.0};
            }
        }
    }
    return {.steps = {LatticeField(lattice, std::move(displacements))}};
}

}  // namespace pectin::test

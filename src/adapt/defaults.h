// The default limits of adaptive meshing.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Sections 4 and 5.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "adapt/triggers/normal_divergence.h"

namespace pectin {

// theta_max in degrees. The paper's examples (section 5) use pi/7.
inline constexpr double kDefaultThetaMax = 180.0 / 7.0;

// theta_min for a given theta_max. The paper's examples use pi/9 beside pi/7.
constexpr double default_theta_min(double theta_max) { return 7.0 / 9.0 * theta_max; }

// L_max is the smallest extent of a cell of the lattice in use (section 4, point 1), so that no
// feature of the deformation fits between the samples. World units.
constexpr double default_l_max(double smallest_cell_extent) { return smallest_cell_extent; }

// How far an unsplit may move the surface, as a fraction of the length of the restored edge: the
// sagitta of a circular arc whose end normals diverge by theta_max, over its chord. theta_max is in
// degrees. The paper has no such limit.
inline double default_flatness(double theta_max) {
    return 0.5 * std::tan(theta_max / 4.0 * std::numbers::pi / 180.0);
}

// How much rougher than at rest an edge may be in a drag, as factors of |n1 - n2| of its end
// normals. The paper has no such allowance. A drag has to bend the edge by a quarter of what it was
// bent before, for it to be refined; decimation needs a margin below that, as with theta_min.
inline constexpr NormalDivergence::RestAllowance kDefaultRestAllowance{.refinement = 1.25,
                                                                       .decimation = 1.1};

// The tolerance of MidpointDistance as a fraction of the diagonal of the object's box. The paper
// does not say what to take.
inline constexpr double kDefaultToleranceFraction = 1e-3;

// The tolerance is at least this fraction of the largest coordinate, whatever the settings say:
// about 2^10 units in the last place of a double, as for the floor below.
inline constexpr double kLeastToleranceFraction = 0x1p-42;

// How many triangles one drag may add, if it moves so many faces. A drag that refines everything it
// moves to half the edge length needs three times as many. The paper has no such limit.
constexpr std::uint64_t default_drag_budget(std::uint64_t faces) {
    return std::max<std::uint64_t>(200'000, 4 * faces);
}

// The floor as a fraction of the diagonal of the object's box. The paper has no floor.
inline constexpr double kDefaultFloorFraction = 1e-4;

// The floor is at least this fraction of the largest coordinate, whatever the settings say. That is
// 2^10 units in the last place of a double, so halves of edges keep about three decimal digits.
inline constexpr double kLeastFloorFraction = 0x1p-42;

}  // namespace pectin

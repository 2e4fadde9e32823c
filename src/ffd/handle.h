// A handle of a drag: what the solver prescribes at one point.
#pragma once

#include <cstddef>

#include "geometry/move.h"
#include "geometry/vec.h"

namespace pectin {

// A point whose displacement is prescribed, and with prescribes_jacobian also the Jacobian there. A
// drag has the same handles from beginning to end.
struct Handle {
    Vec3 point{0.0};
    bool prescribes_jacobian = false;
};

// What is prescribed at a handle. It changes with every frame.
struct HandleMotion {
    Vec3 displacement{0.0};
    Mat3 jacobian{1.0};  // of x + D(x) at the point; ignored unless the handle prescribes it
};

// --- The Jacobian of a move, by its twist and scale.

// Limits of a twist and of a scale and its inverse. Anything beyond is a mistake of a hand or of a
// script.
inline constexpr double kMostDegrees = 3600.0;
inline constexpr double kMostScale = 1000.0;

// Whether the twist and the scale are within the limits, and the axis is finite and not zero.
bool has_valid_rotation(const Move& move);

// Whether the move has a twist or a scale, so that its handle prescribes a Jacobian.
bool rotates(const Move& move);

// Returns a fraction of the move's Jacobian. The Jacobians of fractions that add up to 1 multiply
// to the whole one. Precondition: has_valid_rotation().
Mat3 jacobian(const Move& move, double fraction = 1.0);

// Returns the number of steps that a fraction of the twist needs at least, so that no step rotates
// by more than 80 degrees. From 90 degrees on the symmetric part of the Jacobian is no longer
// positive definite, so that nothing can be proven, and a Jacobian cannot tell a full rotation from
// none.
std::size_t least_steps(const Move& move, double fraction = 1.0);

}  // namespace pectin

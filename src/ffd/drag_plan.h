// Plans a drag as a warp: in one step, along waypoints, or in small steps each of which is proven
// one to one.
// Source: J. Gain, N. Dodgson. Preventing Self-Intersection under Free-Form Deformation. IEEE
// Transactions on Visualization and Computer Graphics 7(4), 2001: small injective deformations are
// composed, and the object is embedded anew between them.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "ffd/drag_solver.h"
#include "ffd/warp.h"
#include "geometry/move.h"

namespace pectin {

struct DragPlan {
    // The first move goes along `via` in straight segments, and a step ends at each waypoint.
    // Everything else (the other moves, twists and scales) happens in the last segment and is
    // spread evenly over it. With fold_free a twist goes through all of its degrees; otherwise only
    // the orientation at its end counts.
    std::vector<Move> moves;
    std::vector<Vec3> pins{}, via{};
    bool fold_free = false;              // otherwise each segment is one step, even if it folds
    std::optional<MirrorPlane> plane{};  // everything happens on both sides of it
    Lattice lattice{};                   // of the first step
    // For a brush, whose lattice is centred on the first move in every step.
    bool is_centred_on_point = false;
    Falloff falloff = Falloff::sharp;
};

struct PlannedDrag {
    Warp warp;                 // at least one step
    std::vector<Vec3> points;  // where the first move's point is before each step
    DragSolver last;           // of the last step
    std::size_t last_segment;  // the step that begins it
};

// The largest number of steps in one drag. Hardly any fold-free drag reaches a target beyond it.
inline constexpr std::size_t kMaxSteps = 256;

// Each step is as long as the proof allows, or shorter so that all remaining steps have the same
// length. The point reaches its target as exactly as in a single solve.
// Refused: what a DragSolver refuses anywhere on the way; rotations beyond the limits of
// ffd/handle.h; a move or waypoint across the plane; more than kMaxSteps steps. With fold_free also
// what no one-to-one deformation reaches: for a point beside the plane a target on it, and with a
// fixed lattice a target outside its zone.
// Cost: one solve and two or three proofs for each step.
std::variant<PlannedDrag, DragRefusal> plan_drag(const DragPlan& plan);

// Returns what plan_drag() refuses because of targets and rotations alone, without solving.
std::optional<DragRefusal> check_drag(const DragPlan& plan);

}  // namespace pectin

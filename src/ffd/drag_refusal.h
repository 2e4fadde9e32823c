// Why a drag cannot be met, in words for the user.
#pragma once

#include <cstddef>
#include <string>

#include "ffd/symmetry.h"
#include "geometry/box.h"
#include "geometry/move.h"
#include "geometry/vec.h"

namespace pectin {

// Says what is wrong and what the user can do about it.
struct DragRefusal {
    const char* kind;  // which of the refusals below it is, for callers that have other words
    std::string what;
};

}  // namespace pectin

namespace pectin::refuse {

// --- The lattice and the number of handles

DragRefusal no_handle();
DragRefusal invalid_lattice();
DragRefusal too_many_constraints(std::size_t most);
DragRefusal invalid_pin(const Vec3& pin);
DragRefusal outside_zone(const Vec3& point, const Box& zone);
// max_gain: how many times as far as the handle a control point may move.
DragRefusal near_border(const Vec3& point, const Box& zone, double max_gain);
// Its kind is too_many_for_lattice if there are more constraints than controls.
// a, b: the points of the two constraints that are most nearly dependent.
DragRefusal dependent(const Vec3& a, const Vec3& b, std::size_t constraints, std::size_t controls);
DragRefusal too_coarse_to_rotate(const Vec3& point);

// --- What is asked of one handle

DragRefusal not_finite(const Vec3& point, const Vec3& d);
DragRefusal invalid_rotation(const Move& move);
DragRefusal different_displacements(const Vec3& point, const Vec3& a, const Vec3& b);
DragRefusal different_rotations(const Vec3& point);
DragRefusal pinned(const Vec3& point, const Vec3& d);
DragRefusal invalid_waypoint(const Vec3& waypoint);

// --- Symmetry

DragRefusal off_plane(const MirrorPlane& plane, const Vec3& point, const Vec3& d);
DragRefusal near_plane(const MirrorPlane& plane, const Vec3& point);
DragRefusal asymmetric_rotation(const MirrorPlane& plane, const Vec3& point);
DragRefusal across_plane(const MirrorPlane& plane, const Vec3& from, const Vec3& to);
DragRefusal onto_plane(const Vec3& to);

// --- Steps

DragRefusal target_outside_zone(const Vec3& target, const Box& zone);
DragRefusal too_many_steps(const Vec3& target, std::size_t most);
DragRefusal too_many_waypoints(std::size_t most);
// A refusal of a later step names points between the moves, so this names the target, too.
DragRefusal on_the_way_to(const Vec3& target, const DragRefusal& refusal);

}  // namespace pectin::refuse

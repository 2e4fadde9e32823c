#include "ffd/drag_refusal.h"

#include "ffd/handle.h"
#include "ffd/lattice.h"
#include "geometry/decimal.h"

namespace pectin::refuse {
namespace {

std::string range(const Box& zone) { return decimal(zone.min) + " to " + decimal(zone.max); }

}  // namespace

DragRefusal no_handle() { return {"no_handle", "a drag needs at least one point to move"}; }

DragRefusal invalid_lattice() {
    return {"invalid_lattice", "the lattice needs a finite origin, cells greater than 0 and " +
                                   std::to_string(kMinDeformable) + " to " +
                                   std::to_string(kMaxDeformable) +
                                   " deformable control points per axis"};
}

DragRefusal too_many_constraints(std::size_t most) {
    return {
        "too_many_constraints",
        "a drag can move and pin at most " + std::to_string(most) +
            " different points; a point with a twist or a scale counts as four of them, and with "
            "symmetry each point beside the plane counts twice; take fewer"};
}

DragRefusal invalid_pin(const Vec3& pin) {
    return {"invalid_pin",
            "pin " + decimal(pin) + " is not a point; its coordinates must be finite"};
}

DragRefusal outside_zone(const Vec3& point, const Box& zone) {
    return {"outside_zone",
            "move point " + decimal(point) + " is not inside the influenced zone " + range(zone) +
                "; move the cage so that the point lies inside, or drag a point that does"};
}

DragRefusal near_border(const Vec3& point, const Box& zone, double max_gain) {
    return {"near_border",
            "move point " + decimal(point) + " is too close to the border of the influenced zone " +
                range(zone) + ": a control point would move over " + decimal(max_gain) +
                " times as far; stay away from the border, or take a larger cage or radius"};
}

DragRefusal dependent(const Vec3& a, const Vec3& b, std::size_t constraints, std::size_t controls) {
    const std::string points = a == b ? decimal(a) : decimal(a) + " and " + decimal(b);
    if (constraints > controls) {
        return {"too_many_for_lattice", "the moves and pins set " + std::to_string(constraints) +
                                            " conditions, more than the " +
                                            std::to_string(controls) +
                                            (controls == 1 ? " control point" : " control points") +
                                            " of the lattice can meet, " + points +
                                            " above all; take fewer of them or a finer lattice"};
    }
    return {"dependent",
            "the lattice cannot tell the moves and pins at " + points +
                " apart well enough to meet both; drop one of them or take a finer lattice"};
}

DragRefusal too_coarse_to_rotate(const Vec3& point) {
    return {"too_coarse_to_rotate",
            "the lattice has too few control points around " + decimal(point) +
                " to twist or scale there; take a larger span, or more control points per axis"};
}

DragRefusal not_finite(const Vec3& point, const Vec3& d) {
    return {"not_finite", "move point " + decimal(point) + " cannot move by " + decimal(d) +
                              "; its target must be finite"};
}

DragRefusal invalid_rotation(const Move& move) {
    const Twist twist = move.twist.value_or(Twist{});
    const std::string asked =
        (move.twist ? "axis " + decimal(twist.axis) + ", " + decimal(twist.degrees) + " degrees, "
                    : std::string()) +
        "scale " + decimal(move.scale);
    return {"invalid_rotation",
            "a twist needs an axis that is not zero, at most " + decimal(kMostDegrees) +
                " degrees either way and a scale from " + decimal(1.0 / kMostScale) + " to " +
                decimal(kMostScale) + ", not " + asked};
}

DragRefusal different_displacements(const Vec3& point, const Vec3& a, const Vec3& b) {
    return {"different_displacements", "move point " + decimal(point) + " is asked to move by " +
                                           decimal(a) + " and by " + decimal(b) +
                                           "; moves of one point must agree"};
}

DragRefusal different_rotations(const Vec3& point) {
    return {"different_rotations",
            "move point " + decimal(point) +
                " is asked to twist or scale in different ways; moves of one point must agree"};
}

DragRefusal pinned(const Vec3& point, const Vec3& d) {
    return {"pinned", "move point " + decimal(point) + " is pinned and asked to move by " +
                          decimal(d) + "; take the pin away or do not move the point"};
}

DragRefusal invalid_waypoint(const Vec3& waypoint) {
    return {"invalid_waypoint",
            "waypoint " + decimal(waypoint) + " is not a point; its coordinates must be finite"};
}

DragRefusal off_plane(const MirrorPlane& plane, const Vec3& point, const Vec3& d) {
    return {"off_plane",
            "move point " + decimal(point) +
                " is on the symmetry plane and can only move within it, for instance to " +
                decimal(plane.onto(point + d)) + ", not to " + decimal(point + d) +
                "; or switch symmetry off"};
}

DragRefusal near_plane(const MirrorPlane& plane, const Vec3& point) {
    return {
        "near_plane",
        "move point " + decimal(point) +
            " is so close to the symmetry plane that moving it and its image apart would tear the "
            "object; take the point on the plane, " +
            decimal(plane.onto(point)) + ", or one farther away from it"};
}

DragRefusal asymmetric_rotation(const MirrorPlane& plane, const Vec3& point) {
    return {"asymmetric_rotation",
            "move point " + decimal(point) +
                " is on the symmetry plane and can only be twisted about its normal, " +
                std::string("xyz").substr(static_cast<std::size_t>(plane.axis), 1) +
                "; take that axis, or switch symmetry off"};
}

DragRefusal across_plane(const MirrorPlane& plane, const Vec3& from, const Vec3& to) {
    return {
        "across_plane",
        "the drag from " + decimal(from) + " to " + decimal(to) +
            " goes across the symmetry plane, where it would meet its own image; keep it on its "
            "side of " +
            decimal(plane.onto(to)) + ", or switch symmetry off"};
}

DragRefusal onto_plane(const Vec3& to) {
    return {
        "onto_plane",
        "the target " + decimal(to) +
            " is on the symmetry plane, which no point beside it can reach without folding, as it "
            "would meet its own image; take a target beside the plane, or drag a point on it"};
}

DragRefusal target_outside_zone(const Vec3& target, const Box& zone) {
    return {"target_outside_zone",
            "without folding nothing leaves the influenced zone " + range(zone) +
                ", and the target " + decimal(target) +
                " is not inside; take a target inside, a larger cage, or fold_free false"};
}

DragRefusal too_many_steps(const Vec3& target, std::size_t most) {
    return {
        "too_many_steps",
        "the target " + decimal(target) + " cannot be reached in " + std::to_string(most) +
            " steps without folding; move less far, or in several drags, stay away from pins, "
            "other moved points, the symmetry plane and the border of the zone, or take a larger "
            "radius"};
}

DragRefusal too_many_waypoints(std::size_t most) {
    return {"too_many_waypoints",
            "a drag takes at most " + std::to_string(most) +
                " steps, and each waypoint ends one; take fewer waypoints, or several drags"};
}

DragRefusal on_the_way_to(const Vec3& target, const DragRefusal& refusal) {
    return {refusal.kind, "on the way to " + decimal(target) + ", " + refusal.what};
}

}  // namespace pectin::refuse

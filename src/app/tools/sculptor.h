// Dragging of a surface point with the mouse. The grabbed point stays under the cursor.
//
// A movement of the mouse becomes a Move here, and Session::drag_to() turns that into displacements
// (session/drag.cpp). docs/architecture.md follows it from the mouse to the screen.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/tools/drag_constraint.h"
#include "geometry/camera.h"
#include "session/session.h"

namespace pectin {

// Where the grabbed point moves: in the plane parallel to the picture, or along the surface normal.
enum class DragPath { view_plane, normal };

// Returns the point where `ray` meets the plane through `from` parallel to the picture; nothing if
// it does not meet it.
std::optional<Vec3> on_view_plane(const Camera& camera, const Vec3& from, const Ray& ray);
// Returns the point nearest to `ray` on the line through `from` along `normal`, which has unit
// length. If the line runs nearly towards the eye, all of its points lie under the cursor. Moving
// the cursor upwards by a length then moves the point outwards by the same length.
// first: the ray with which the point was grabbed.
Vec3 on_normal(const Camera& camera, const Vec3& from, const Vec3& normal, const Ray& first,
               const Ray& ray);
// Returns the point where `ray` meets the plane through `from` across the axis. If the plane is
// seen nearly from its edge (by the ray with which the point was grabbed), it is the point of the
// plane that is nearest to on_view_plane().
std::optional<Vec3> on_plane_across(const Camera& camera, const Vec3& from, int axis,
                                    const Ray& first, const Ray& ray);

// Returns the point of the constraint's axis or plane through `from` that follows the cursor.
// Precondition: the constraint has an axis.
std::optional<Vec3> on_constraint(const DragConstraint& constraint, const Camera& camera,
                                  const Vec3& from, const Ray& first, const Ray& ray);

// Returns `to`, moved so that a point on the plane of symmetry stays on it, and any other point
// stays on its side. cell: the extent of the lattice's cells along the normal of the plane.
Vec3 on_own_side(const MirrorPlane& plane, double cell, const Vec3& from, const Vec3& to);

class Sculptor {
  public:
    // Begins a drag of the picked point under the ray. The pins stay where they are.
    // Precondition: the object has not changed since the pick, and there is no active drag.
    Done grab(Session& session, const Pick& pick, const Ray& ray, std::span<const Vec3> pins = {},
              const DragOptions& options = {});
    // Moves the point under the ray, with the requested twist and scale. With symmetry, it stays on
    // its side of the plane. strength: how much of the cursor's way the point follows, unless a
    // distance is typed. Returns whether the object has moved. After a refusal the object is as in
    // the frame before, and twist and scale requested since then are discarded.
    Result<bool> drag(Session& session, const Camera& camera, const Ray& ray, DragPath path,
                      double strength = 1.0);
    // Keys for the constraint of the active drag, which ends with it. After a change a fold-free
    // drag that has waypoints begins anew, so that it goes straight from the start. Returns whether
    // the key or character is one of the constraint's. Precondition: is_dragging().
    bool press_key(Session& session, Key key, bool shift);
    bool type(Session& session, unsigned int character);
    const DragConstraint& constraint() const { return constraint_; }
    // Forgets the drag, once the session has ended or cancelled it.
    void end() {
        grabbed_.reset();
        constraint_.clear();
    }

    // --- Twist and scale of the point's surroundings, from the next drag() on. The twist follows
    // the right-hand rule about the surface normal. Each step scales by kScalePerStep.
    void rotate(double degrees) { grabbed_->requested.degrees += degrees; }
    void scale_by_steps(double steps) { grabbed_->requested.scale_steps += steps; }
    static constexpr double kScalePerStep = 1.05;

    bool is_dragging() const { return grabbed_.has_value(); }
    // --- The active drag. Precondition: is_dragging().
    const Vec3& from() const { return grabbed_->pick.point; }
    const Vec3& to() const { return grabbed_->applied.to; }
    const Vec3& normal() const { return grabbed_->pick.normal; }
    double degrees() const { return grabbed_->applied.degrees; }
    double scale() const;

  private:
    struct Goal {
        Vec3 to;
        double degrees = 0.0, scale_steps = 0.0;
        bool operator==(const Goal&) const = default;
    };
    struct Grabbed {
        Pick pick;
        Ray ray;
        Goal requested, applied;
        std::vector<Vec3> pins{};
        DragOptions options{};
    };
    Move move_to(const Goal& goal) const;
    std::optional<Vec3> under_cursor(const Camera& camera, const Ray& ray, DragPath path) const;
    void straighten(Session& session);

    std::optional<Grabbed> grabbed_;
    DragConstraint constraint_;
};

}  // namespace pectin

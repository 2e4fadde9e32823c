// The drag of a surface point by the mouse: the grabbed point stays under the cursor.
//
// A movement of the mouse becomes a Move here, and Session::drag_to() turns that into displacements
// (session/drag.cpp). docs/architecture.md follows it from the mouse to the screen.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "geometry/camera.h"
#include "session/session.h"

namespace pectin {

// Where the grabbed point is to go.
enum class DragPath { view_plane, normal };

// The point of the plane through `from`, parallel to the picture, that `ray` meets; nothing where
// it never does.
std::optional<Vec3> on_view_plane(const Camera& camera, const Vec3& from, const Ray& ray);
// The point of the line through `from` along `normal` (unit) that comes nearest to `ray`. Where
// the line runs towards the eye, all of it lies under the cursor, and going up the picture by a
// length goes out by as much: `ray` and `first`, the ray that grabbed, tell how far.
Vec3 on_normal(const Camera& camera, const Vec3& from, const Vec3& normal, const Ray& first,
               const Ray& ray);

class Sculptor {
  public:
    // Begins a drag of the picked point under the ray; the pins stay. Precondition: nothing has
    // changed since the pick and no drag is active. Returns why not, if not.
    std::optional<std::string> grab(Session& session, const Pick& pick, const Ray& ray,
                                    std::span<const Vec3> pins = {},
                                    const DragOptions& options = {});
    // Takes the point there, turned and scaled as asked for; with symmetry on not beyond the plane.
    // Whether the object changed is in the session's dirty elements. A refusal leaves the frame
    // before, and takes back what was asked of turn and scale since.
    std::optional<std::string> drag(Session& session, const Camera& camera, const Ray& ray,
                                    DragPath path);
    // What it came to, if anything.
    std::optional<command::Drag> release(Session& session);
    void cancel(Session& session);

    // --- From the next drag() on, the surroundings of the point turn about the surface's normal,
    // by the right hand, and grow by kGrowth for each step.
    void rotate(double degrees) { grabbed_->asked.degrees += degrees; }
    void grow(double steps) { grabbed_->asked.growth += steps; }
    static constexpr double kGrowth = 1.05;

    bool is_dragging() const { return grabbed_.has_value(); }
    // Of the active drag.
    const Vec3& from() const { return grabbed_->pick.point; }
    const Vec3& to() const { return grabbed_->done.to; }
    const Vec3& normal() const { return grabbed_->pick.normal; }
    double degrees() const { return grabbed_->done.degrees; }
    double scale() const;

  private:
    struct Goal {
        Vec3 to;
        double degrees = 0.0, growth = 0.0;
        bool operator==(const Goal&) const = default;
    };
    struct Grabbed {
        Pick pick;
        Ray ray;
        Goal asked, done;
    };
    Move move_to(const Goal& goal) const;

    std::optional<Grabbed> grabbed_;
};

}  // namespace pectin

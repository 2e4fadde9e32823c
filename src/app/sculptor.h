// The drag of a surface point by the mouse: the grabbed point stays under the cursor.
#pragma once

#include <optional>
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
    // Begins a drag of the point under the ray. Precondition: `pick` is of that ray, nothing has
    // changed since and no drag is in hand. Returns why not, if not.
    std::optional<std::string> grab(Session& session, const Pick& pick, const Ray& ray);
    // Takes the point there; whether the object changed is in the session's dirty elements.
    std::optional<std::string> drag(Session& session, const Camera& camera, const Ray& ray,
                                    DragPath path);
    // What it came to, if anything.
    std::optional<command::Drag> release(Session& session);
    void cancel(Session& session);

    bool is_dragging() const { return grabbed_.has_value(); }
    // Of the drag in hand.
    const Vec3& from() const { return grabbed_->pick.point; }
    const Vec3& to() const { return grabbed_->to; }

  private:
    struct Grabbed {
        Pick pick;
        Ray ray;
        Vec3 to;
    };
    std::optional<Grabbed> grabbed_;
};

}  // namespace pectin

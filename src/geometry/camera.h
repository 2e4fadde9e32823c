// A perspective camera: matrices for drawing, rays for picking, moves for looking around.
//
// World space, +y up by custom. Camera space: x to the right, y up, looking along -z. Pixels have
// their origin in the top left corner of the picture; the centre of the first is (0.5, 0.5).
#pragma once

#include <optional>
#include <span>

#include "geometry/box.h"
#include "geometry/ray.h"
#include "geometry/vec.h"

namespace pectin {

using IVec2 = glm::ivec2;
using Mat4 = glm::dmat4;  // column-major

// Distances along the view direction between which things are drawn.
struct DepthRange {
    double near = 0.1, far = 100.0;
};

struct Camera {
    Vec3 eye{0.0, 0.0, 3.0};
    Vec3 target{0.0};        // what it looks at and turns about
    Vec3 up{0.0, 1.0, 0.0};  // need not be at right angles to the view, only not along it
    double fov = 45.0;       // vertical, degrees

    // Finite, with a view direction that `up` is not along and 0 < fov < 180; all others but ==
    // take that for granted.
    bool is_valid() const;

    double distance() const { return glm::distance(eye, target); }
    Vec3 forward() const;  // unit, as the next two
    Vec3 right() const;
    Vec3 true_up() const;

    Mat4 view() const;                                               // world to camera
    Mat4 projection(double aspect, const DepthRange& depths) const;  // camera to clip, z in [-1, 1]

    // Through a point of the picture; its direction is unit.
    Ray ray_through(const Vec2& pixel, const IVec2& size) const;
    // Where a world point is in the picture, in it or not; nothing behind the eye.
    std::optional<Vec2> project(const Vec3& point, const IVec2& size) const;
    // The world length of one pixel at the depth of `point`.
    double pixel_length(const Vec3& point, const IVec2& size) const;

    bool operator==(const Camera&) const = default;
};

// The tightest range about the box, its near end kept off 0 for the sake of depth precision.
DepthRange depth_range(const Camera& camera, const Box& box);

// Where a new view looks from: the front, somewhat from the right and above.
inline constexpr Vec3 kFitDirection{0.5, 0.35, 1.0};
// Looks from `direction` (target to eye), as near as shows all of the points, with these in the
// middle of the picture and the target at their depth. aspect: width / height of the picture. No
// points, or all at one place, count as a box of size 1. O(n).
Camera fit(std::span<const Vec3> points, double aspect, const Vec3& direction = kFitDirection,
           double fov = 45.0);
// The same for the corners of a box; looser for what is round.
Camera fit(const Box& box, double aspect, const Vec3& direction = kFitDirection, double fov = 45.0);

// Turns the eye about `pivot` (often the target), angles in radians: yaw about world up (`up`),
// pitch about the camera's right; stops short of looking along up.
Camera orbited(const Camera& camera, double yaw, double pitch, const Vec3& pivot);
// Moves eye and target so that what is at the target's depth goes by `pixels` over the picture.
Camera panned(const Camera& camera, const Vec2& pixels, const IVec2& size);
// Brings the eye to `factor` times its distance from the target; below 1 is nearer.
Camera zoomed(const Camera& camera, double factor);

}  // namespace pectin

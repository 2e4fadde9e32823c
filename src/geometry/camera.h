// A perspective camera: matrices for drawing, rays for picking, and the movements of navigation.
//
// In world space +y is up by convention. In camera space x points to the right and y up, and the
// camera looks along -z. The origin of pixels is the top left corner of the picture; the centre of
// the first pixel is (0.5, 0.5).
#pragma once

#include <optional>
#include <span>

#include "geometry/box.h"
#include "geometry/ray.h"
#include "geometry/vec.h"

namespace pectin {

using IVec2 = glm::ivec2;
using Mat4 = glm::dmat4;  // column-major

// The distances along the view direction between which objects are drawn.
struct DepthRange {
    double near = 0.1, far = 100.0;
};

struct Camera {
    Vec3 eye{0.0, 0.0, 3.0};
    Vec3 target{0.0};        // the point it looks at, usually the centre of orbits
    Vec3 up{0.0, 1.0, 0.0};  // not parallel to the view direction
    double fov = 45.0;       // vertical, degrees

    // Whether the camera is finite, `up` is not parallel to the view direction, and 0 < fov < 180.
    // This is a precondition of all other functions but ==.
    bool is_valid() const;

    double distance() const { return glm::distance(eye, target); }
    // Unit vectors. true_up is perpendicular to the view direction.
    Vec3 forward() const;
    Vec3 right() const;
    Vec3 true_up() const;

    Mat4 view() const;                                               // world to camera
    Mat4 projection(double aspect, const DepthRange& depths) const;  // camera to clip, z in [-1, 1]

    // The ray through a point of the picture. Its direction has unit length.
    Ray ray_through(const Vec2& pixel, const IVec2& size) const;
    // The pixel of a world point, which may lie outside the picture; nothing for a point behind the
    // eye.
    std::optional<Vec2> project(const Vec3& point, const IVec2& size) const;
    // The world length of one pixel at the depth of `point`.
    double pixel_length(const Vec3& point, const IVec2& size) const;

    bool operator==(const Camera&) const = default;
};

// The tightest range around the box. Its near end stays above 0 for the sake of depth precision.
DepthRange depth_range(const Camera& camera, const Box& box);

// The direction from which a new view looks: from the front, somewhat to the right and above.
inline constexpr Vec3 kFitDirection{0.5, 0.35, 1.0};
// Returns the nearest camera that looks from `direction` (target to eye) and shows all points. They
// are in the middle of the picture, and the target is at their depth. aspect: width / height of the
// picture. If there are no points or they all coincide, a box of size 1 is shown. O(n).
Camera fit(std::span<const Vec3> points, double aspect, const Vec3& direction = kFitDirection,
           double fov = 45.0);
// The same for the corners of a box. Round objects leave more space.
Camera fit(const Box& box, double aspect, const Vec3& direction = kFitDirection, double fov = 45.0);

// Rotates the camera about `pivot`, often the target: by yaw about `up`, and by pitch about the
// camera's right, in radians. The pitch is limited before the camera looks along `up`.
Camera orbited(const Camera& camera, double yaw, double pitch, const Vec3& pivot);
// Moves eye and target so that objects at the depth of the target move by `pixels` in the picture.
Camera panned(const Camera& camera, const Vec2& pixels, const IVec2& size);
// Multiplies the distance of the eye from the target by `factor`.
Camera zoomed(const Camera& camera, double factor);

}  // namespace pectin

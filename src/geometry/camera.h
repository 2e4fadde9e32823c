// A camera: matrices for drawing, rays for picking, and the movements of navigation.
//
// In camera space x points to the right and y up, and the camera looks along -z. The origin of
// pixels is the top left corner of the picture; the centre of the first pixel is (0.5, 0.5).
#pragma once

#include <cstdint>
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

// Perspective pictures show what is seen from the eye. Orthographic ones show what is seen along
// parallel lines: objects of all depths, also behind the eye, are as large as those at the depth of
// the target are in perspective.
enum class Projection : std::uint8_t { perspective, orthographic };

struct Camera {
    Vec3 eye{0.0, 0.0, 3.0};
    Vec3 target{0.0};        // the point it looks at; its distance is the scale of the picture
    Vec3 up{0.0, 1.0, 0.0};  // not parallel to the view direction
    double fov = 45.0;       // vertical, degrees
    Projection projection = Projection::perspective;

    // Whether the camera is finite, `up` is not parallel to the view direction, and 0 < fov < 180.
    // This is a precondition of all other functions but ==.
    bool is_valid() const;
    bool is_orthographic() const { return projection == Projection::orthographic; }

    double distance() const { return glm::distance(eye, target); }
    // Distance of a point from the eye along the view direction; negative behind the eye.
    double depth(const Vec3& point) const { return glm::dot(point - eye, forward()); }
    // Unit vectors. true_up is perpendicular to the view direction.
    Vec3 forward() const;
    Vec3 right() const;
    Vec3 true_up() const;

    Mat4 view() const;  // world to camera
    // Camera to clip, z in [-1, 1].
    Mat4 projection_matrix(double aspect, const DepthRange& depths) const;

    // The ray through a point of the picture. Its direction has unit length. In perspective it
    // begins at the eye. In orthographic pictures it begins 10^6 times the distance of the target
    // before the eye, so that it meets everything that is drawn; its points are then accurate to
    // 10^-6 pixels.
    Ray ray_through(const Vec2& pixel, const IVec2& size) const;
    // The pixel of a world point, which may lie outside the picture; nothing for a point behind the
    // eye of a perspective picture.
    std::optional<Vec2> project(const Vec3& point, const IVec2& size) const;
    // The world length of one pixel at the depth of `point`.
    double pixel_length(const Vec3& point, const IVec2& size) const;

    bool operator==(const Camera&) const = default;
};

// The tightest range around the box. In perspective its near end stays above 0 for the sake of
// depth precision.
DepthRange depth_range(const Camera& camera, const Box& box);

// A rectangle of the picture. The unit is half the picture's height; (0, 0) is the middle of the
// picture, x is to the right and y up.
struct PictureArea {
    Vec2 min{-1.0}, max{1.0};
};

// The direction from which a new view looks: from the front, somewhat to the right and above.
inline constexpr Vec3 kFitDirection{0.5, 0.35, 1.0};

struct FitOptions {
    PictureArea area{};
    Vec3 direction = kFitDirection;  // from the target to the eye, of any length above 0
    Vec3 up{0.0, 1.0, 0.0};          // another one is used if the direction is parallel to it
    double fov = 45.0;
    Projection projection = Projection::perspective;
};

// Returns the nearest camera that shows all points in the area, less a margin of 6 % on each side.
// They are in its middle, and the target is at their depth. If there are no points or they all
// coincide, a box of size 1 is shown. The picture is not shifted: what is seen in an area beside
// its middle is seen at an angle, as at the side of any picture. O(n).
Camera fit(std::span<const Vec3> points, const FitOptions& options);
// The same for the whole picture. aspect: its width / height.
Camera fit(std::span<const Vec3> points, double aspect, const Vec3& direction = kFitDirection,
           double fov = 45.0);
// The same for the corners of a box. Round objects leave more space.
Camera fit(const Box& box, double aspect, const Vec3& direction = kFitDirection, double fov = 45.0);

// Rotates the camera about `pivot`, which keeps its pixel: by yaw about `up`, and by pitch about
// the camera's right, in radians. The pitch is limited before the camera looks along `up`.
Camera orbited(const Camera& camera, double yaw, double pitch, const Vec3& pivot);
// Rotates the camera about `pivot`, which keeps its pixel, so that it looks from this direction
// with this `up`. direction: from the target to the eye, not parallel to `up`.
Camera looking_from(const Camera& camera, const Vec3& direction, const Vec3& up, const Vec3& pivot);
// Moves eye and target so that objects at the depth of the target move by `pixels` in the picture.
Camera panned(const Camera& camera, const Vec2& pixels, const IVec2& size);
// Moves eye and target towards `anchor`, which keeps its pixel: their distances from it are
// multiplied by `factor`, and so is their distance from each other.
Camera zoomed(const Camera& camera, double factor, const Vec3& anchor);
// Moves the target along the view to the depth of the point. A perspective picture stays as it is,
// and in an orthographic one the eye moves as well, so that it stays as it is, too. A point that is
// not in front of the eye of a perspective picture changes nothing.
Camera focused_on(const Camera& camera, const Vec3& point);

}  // namespace pectin

#include "geometry/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace pectin {
namespace {

// The least sine of the angle between the view direction and `up`. Rounding decides below it.
constexpr double kLeastTilt = 1e-6;
// The least near distance as a fraction of the far one. A depth buffer of 24 bits then still
// resolves 1e-3 of an object.
constexpr double kLeastNear = 1e-4;
// The margin that fit() leaves around the object, as a factor.
constexpr double kFitMargin = 1.14;
// The largest sine of the pitch of an orbit: 0.6 degrees from straight up and down.
constexpr double kSteepest = 0.99995;

double half_height(const Camera& camera) { return std::tan(glm::radians(camera.fov) / 2.0); }

Vec3 corner(const Box& box, int i) {
    return {(i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
            (i & 4) ? box.max.z : box.min.z};
}

}  // namespace

bool Camera::is_valid() const {
    if (!is_finite(eye) || !is_finite(target) || !is_finite(up)) return false;
    const Vec3 view_direction = target - eye;
    const double reach = glm::length(view_direction), up_length = glm::length(up);
    if (!(reach > 0.0) || !(up_length > 0.0) || !std::isfinite(reach * up_length)) return false;
    const double sine = glm::length(glm::cross(view_direction / reach, up / up_length));
    return sine > kLeastTilt && fov > 0.0 && fov < 180.0;
}

Vec3 Camera::forward() const { return glm::normalize(target - eye); }
Vec3 Camera::right() const { return glm::normalize(glm::cross(forward(), glm::normalize(up))); }
Vec3 Camera::true_up() const { return glm::cross(right(), forward()); }

Mat4 Camera::view() const {
    const Vec3 x = right(), z = -forward(), y = glm::cross(z, x);
    return {x.x,
            y.x,
            z.x,
            0.0,
            x.y,
            y.y,
            z.y,
            0.0,
            x.z,
            y.z,
            z.z,
            0.0,
            -glm::dot(x, eye),
            -glm::dot(y, eye),
            -glm::dot(z, eye),
            1.0};
}

Mat4 Camera::projection(double aspect, const DepthRange& depths) const {
    return glm::perspective(glm::radians(fov), aspect, depths.near, depths.far);
}

Ray Camera::ray_through(const Vec2& pixel, const IVec2& size) const {
    const double height = size.y, scale = 2.0 * half_height(*this) / height;
    const double x = (pixel.x - 0.5 * size.x) * scale, y = (0.5 * height - pixel.y) * scale;
    return {eye, glm::normalize(forward() + x * right() + y * true_up())};
}

std::optional<Vec2> Camera::project(const Vec3& point, const IVec2& size) const {
    const Vec3 to = point - eye;
    const double depth = glm::dot(to, forward());
    if (!(depth > 0.0)) return std::nullopt;
    const double scale = size.y / (2.0 * half_height(*this) * depth);
    return Vec2{0.5 * size.x + glm::dot(to, right()) * scale,
                0.5 * size.y - glm::dot(to, true_up()) * scale};
}

double Camera::pixel_length(const Vec3& point, const IVec2& size) const {
    return 2.0 * half_height(*this) * glm::dot(point - eye, forward()) / size.y;
}

DepthRange depth_range(const Camera& camera, const Box& box) {
    if (box.is_empty()) return {};
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (int i = 0; i < 8; ++i) {
        const double depth = glm::dot(corner(box, i) - camera.eye, camera.forward());
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    // The slack keeps rounding from clipping a flat box.
    const double slack = 1e-3 * (most - least) + 1e-6 * std::abs(most);
    if (!(most + slack > 0.0)) return {};  // all of it is behind the eye
    return {std::max(least - slack, kLeastNear * (most + slack)), most + slack};
}

Camera fit(std::span<const Vec3> points, double aspect, const Vec3& direction, double fov) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    if (!(box.diagonal() > 0.0)) {
        const Vec3 centre = box.is_empty() ? Vec3{0.0} : box.centre();
        return fit(Box{.min = centre - 0.5, .max = centre + 0.5}, aspect, direction, fov);
    }
    const Vec3 target = box.centre(), back = glm::normalize(direction);
    const Vec3 up = std::abs(back.y) > kSteepest ? Vec3{0.0, 0.0, -back.y} : Vec3{0.0, 1.0, 0.0};
    Camera camera{.eye = target + back, .target = target, .up = up, .fov = fov};
    // With z towards the eye, a point (x, y, z) is visible from (ex, ey, d) if |x - ex| <= (d - z)
    // tan, and likewise for y. So the extremes of z tan + x and z tan - x determine the eye.
    const Vec3 right = camera.right(), true_up = camera.true_up();
    const double tan_y = half_height(camera) / kFitMargin, tan_x = tan_y * aspect;
    const double none = -std::numeric_limits<double>::infinity();
    Vec2 above{none}, below{none};
    for (const Vec3& p : points) {
        const Vec2 at{glm::dot(p - target, right), glm::dot(p - target, true_up)};
        const Vec2 reach = glm::dot(p - target, back) * Vec2{tan_x, tan_y};
        above = glm::max(above, reach + at);
        below = glm::max(below, reach - at);
    }
    const Vec2 middle = 0.5 * (above - below), half = 0.5 * (above + below);
    camera.target += middle.x * right + middle.y * true_up;
    camera.eye = camera.target + std::max(half.x / tan_x, half.y / tan_y) * back;
    return camera;
}

Camera fit(const Box& box, double aspect, const Vec3& direction, double fov) {
    std::array<Vec3, 8> corners{};
    for (int i = 0; i < 8 && !box.is_empty(); ++i)
        corners[static_cast<std::size_t>(i)] = corner(box, i);
    return fit(std::span<const Vec3>(corners), aspect, direction, fov);
}

Camera orbited(const Camera& camera, double yaw, double pitch, const Vec3& pivot) {
    const Vec3 up = glm::normalize(camera.up);
    const double now = std::asin(std::clamp(glm::dot(camera.forward(), up), -1.0, 1.0));
    const double steepest = std::max(std::asin(kSteepest), std::abs(now));
    const double tilt = std::clamp(now + pitch, -steepest, steepest) - now;
    const Mat4 rotation = glm::rotate(glm::rotate(Mat4{1.0}, yaw, up), tilt, camera.right());
    const auto rotated = [&](const Vec3& p) { return pivot + Mat3(rotation) * (p - pivot); };
    Camera result = camera;
    result.eye = rotated(camera.eye);
    result.target = rotated(camera.target);
    return result;
}

Camera panned(const Camera& camera, const Vec2& pixels, const IVec2& size) {
    const double pixel = camera.pixel_length(camera.target, size);
    const Vec3 shift = pixel * (pixels.y * camera.true_up() - pixels.x * camera.right());
    Camera result = camera;
    result.eye += shift;
    result.target += shift;
    return result;
}

Camera zoomed(const Camera& camera, double factor) {
    Camera result = camera;
    result.eye = camera.target + factor * (camera.eye - camera.target);
    return result;
}

}  // namespace pectin

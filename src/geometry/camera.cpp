#include "geometry/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace pectin {
namespace {

// The least sine of the angle between the view direction and `up`. Rounding decides below it.
constexpr double kLeastTilt = 1e-6;
// How far before the eye the rays of an orthographic picture begin, in distances of the target.
constexpr double kRayStart = 1e6;
// The least near distance as a fraction of the far one. A depth buffer of 24 bits then still
// resolves 1e-3 of an object.
constexpr double kLeastNear = 1e-4;
// fit() chooses another `up` if the sine of its angle to the view direction is smaller.
constexpr double kLeastFitTilt = 1e-5;
// The margin that fit() leaves around the object, as a factor.
constexpr double kFitMargin = 1.14;
// The largest sine of the pitch of an orbit: 0.6 degrees from straight up and down.
constexpr double kSteepest = 0.99995;
// The least distance of an eye that fit() places from the points, in diagonals of their box.
constexpr double kFitClearance = 1e-3;

double tangent(double fov) { return std::tan(glm::radians(fov) / 2.0); }

// Half the height of the picture in world lengths, at this depth.
double half_height(const Camera& camera, double depth) {
    return tangent(camera.fov) * (camera.is_orthographic() ? camera.distance() : depth);
}

Vec3 corner(const Box& box, int i) {
    return {(i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
            (i & 4) ? box.max.z : box.min.z};
}

std::array<Vec3, 8> corners(const Box& box) {
    std::array<Vec3, 8> all{};
    for (int i = 0; i < 8; ++i) all[static_cast<std::size_t>(i)] = corner(box, i);
    return all;
}

// The eye's position, relative to the target of `camera`, from which all points are seen in the
// area: to the right, upwards, and back.
//
// With z towards the eye, a point (x, y, z) is seen between the tangents `low` and `high` from (ex,
// ey, d) if low (d - z) <= x - ex <= high (d - z), and likewise for y. So the greatest x + z high
// and the least x + z low determine d and ex. In an orthographic picture z counts as 0.
Vec3 fitting_eye(std::span<const Vec3> points, double diagonal, const Camera& camera,
                 const PictureArea& area) {
    const Vec3 right = camera.right(), up = camera.true_up(), back = -camera.forward();
    const Vec2 middle = 0.5 * (area.min + area.max);
    const Vec2 half = 0.5 / kFitMargin * (area.max - area.min);
    const Vec2 low = tangent(camera.fov) * (middle - half);
    const Vec2 high = tangent(camera.fov) * (middle + half);
    const double none = -std::numeric_limits<double>::infinity();
    Vec2 above{none}, below{-none};
    double nearest = none;
    for (const Vec3& p : points) {
        const Vec2 at{glm::dot(p - camera.target, right), glm::dot(p - camera.target, up)};
        const double z = glm::dot(p - camera.target, back);
        const double reach = camera.is_orthographic() ? 0.0 : z;
        above = glm::max(above, at + reach * high);
        below = glm::min(below, at + reach * low);
        nearest = std::max(nearest, z);
    }
    const Vec2 distances = (above - below) / (high - low);
    double distance = std::max(distances.x, distances.y);
    if (camera.is_orthographic()) nearest = 0.0;
    distance = std::max(distance, nearest + kFitClearance * diagonal);
    return Vec3(0.5 * (above + below - distance * (high + low)), distance);
}

// Moves eye and target by a map of their positions relative to the pivot.
template <typename Map>
Camera moved_about(const Camera& camera, const Vec3& pivot, const Map& map) {
    Camera result = camera;
    result.eye = pivot + map(camera.eye - pivot);
    result.target = pivot + map(camera.target - pivot);
    return result;
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

Mat4 Camera::projection_matrix(double aspect, const DepthRange& depths) const {
    if (!is_orthographic()) {
        return glm::perspective(glm::radians(fov), aspect, depths.near, depths.far);
    }
    const double y = half_height(*this, 0.0), x = aspect * y;
    return glm::ortho(-x, x, -y, y, depths.near, depths.far);
}

Ray Camera::ray_through(const Vec2& pixel, const IVec2& size) const {
    const double height = size.y, scale = 2.0 * half_height(*this, 1.0) / height;
    const double x = (pixel.x - 0.5 * size.x) * scale, y = (0.5 * height - pixel.y) * scale;
    const Vec3 aside = x * right() + y * true_up();
    if (is_orthographic()) return {eye + aside - kRayStart * distance() * forward(), forward()};
    return {eye, glm::normalize(forward() + aside)};
}

std::optional<Vec2> Camera::project(const Vec3& point, const IVec2& size) const {
    const double depth = this->depth(point);
    if (!is_orthographic() && !(depth > 0.0)) return std::nullopt;
    const Vec3 to = point - eye;
    const double scale = size.y / (2.0 * half_height(*this, depth));
    return Vec2{0.5 * size.x + glm::dot(to, right()) * scale,
                0.5 * size.y - glm::dot(to, true_up()) * scale};
}

double Camera::pixel_length(const Vec3& point, const IVec2& size) const {
    return 2.0 * half_height(*this, depth(point)) / size.y;
}

DepthRange depth_range(const Camera& camera, const Box& box) {
    if (box.is_empty()) return {};
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (int i = 0; i < 8; ++i) {
        const double depth = camera.depth(corner(box, i));
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    // The slack keeps rounding from clipping a flat box.
    const double slack = 1e-3 * (most - least) + 1e-6 * std::abs(most);
    if (camera.is_orthographic()) return {least - slack, most + slack};
    if (!(most + slack > 0.0)) return {};  // all of it is behind the eye
    return {std::max(least - slack, kLeastNear * (most + slack)), most + slack};
}

Camera fit(std::span<const Vec3> points, const FitOptions& options) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    if (!(box.diagonal() > 0.0)) {
        const Vec3 centre = box.is_empty() ? Vec3{0.0} : box.centre();
        return fit(corners(Box{.min = centre - 0.5, .max = centre + 0.5}), options);
    }
    const Vec3 target = box.centre(), back = glm::normalize(options.direction);
    Camera camera{.eye = target + back,
                  .target = target,
                  .up = glm::normalize(options.up),
                  .fov = options.fov,
                  .projection = options.projection};
    if (glm::length(glm::cross(back, camera.up)) < kLeastFitTilt) {
        // Looking down, what is at the back of the model is up in the picture.
        const double down = glm::dot(back, camera.up);
        camera.up = std::abs(camera.up.y) > 0.5 ? Vec3{0.0, 0.0, -down} : Vec3{0.0, down, 0.0};
    }
    const Vec3 eye = fitting_eye(points, box.diagonal(), camera, options.area);
    camera.target = target + eye.x * camera.right() + eye.y * camera.true_up();
    camera.eye = camera.target + eye.z * back;
    return camera;
}

Camera fit(std::span<const Vec3> points, double aspect, const Vec3& direction, double fov) {
    return fit(points, {.area = {.min = {-aspect, -1.0}, .max = {aspect, 1.0}},
                        .direction = direction,
                        .fov = fov});
}

Camera fit(const Box& box, double aspect, const Vec3& direction, double fov) {
    if (box.is_empty()) return fit(std::span<const Vec3>{}, aspect, direction, fov);
    return fit(corners(box), aspect, direction, fov);
}

Camera orbited(const Camera& camera, double yaw, double pitch, const Vec3& pivot) {
    const Vec3 up = glm::normalize(camera.up);
    const double now = std::asin(std::clamp(glm::dot(camera.forward(), up), -1.0, 1.0));
    const double steepest = std::max(std::asin(kSteepest), std::abs(now));
    const double tilt = std::clamp(now + pitch, -steepest, steepest) - now;
    const Mat4 rotation = glm::rotate(glm::rotate(Mat4{1.0}, yaw, up), tilt, camera.right());
    return moved_about(camera, pivot, [&](const Vec3& p) { return Mat3(rotation) * p; });
}

Camera looking_from(const Camera& camera, const Vec3& direction, const Vec3& up,
                    const Vec3& pivot) {
    const Camera goal{.eye = direction, .target = Vec3{0.0}, .up = up};
    const Mat3 from{camera.right(), camera.true_up(), camera.forward()};
    const Mat3 to{goal.right(), goal.true_up(), goal.forward()};
    Camera result =
        moved_about(camera, pivot, [&](const Vec3& p) { return to * (glm::transpose(from) * p); });
    result.up = up;
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

Camera zoomed(const Camera& camera, double factor, const Vec3& anchor) {
    return moved_about(camera, anchor, [&](const Vec3& p) { return factor * p; });
}

Camera focused_on(const Camera& camera, const Vec3& point) {
    const double depth = camera.depth(point);
    Camera result = camera;
    if (camera.is_orthographic()) {
        const Vec3 shift = (depth - camera.distance()) * camera.forward();
        result.eye += shift;
        result.target += shift;
    } else if (depth > 0.0) {
        result.target = camera.eye + depth * camera.forward();
    }
    return result;
}

}  // namespace pectin

#include "app/navigation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pectin {
namespace {

// The camera turns by half a turn when the mouse moves over the window's height.
constexpr double kTurnPerHeight = std::numbers::pi;
constexpr double kZoomPerNotch = 0.88;
constexpr double kMostNotches = 10.0;  // of one event
// Moving the mouse over the window's height zooms by this factor.
constexpr double kZoomPerHeight = 8.0;
// Where the cursor is beside the surface, the eye does not come nearer to the point under it than
// this part of the eye's distance from the surface. Else it would be caught in empty space, where
// further zooms have hardly an effect.
constexpr double kEmptyClearance = 0.5;
// How exactly the farthest zoom that is allowed is found, as a number of halvings.
constexpr int kHalvings = 24;
// In how many steps a movement of the eye is checked at most. It ends there if they are not enough.
constexpr int kMostSteps = 64;
// The length of such a step: nearly all that is certain to be clear, but at least this part of the
// distance from the surface, since the eye may be moving along it or away.
constexpr double kSafeStep = 0.999, kShortStep = 0.1;

bool is_inside(const Vec2& pixel, const IVec2& size) {
    return 0.0 <= pixel.x && pixel.x <= size.x && 0.0 <= pixel.y && pixel.y <= size.y;
}

}  // namespace

// --- Gestures.

void Navigation::begin(NavigationMode mode, MouseButton button, const Vec2& at, const IVec2& size) {
    gesture_ = Gesture{mode, button, at, camera_.target, {camera_.target, false}};
    prepare(*gesture_, size);
}

void Navigation::begin_orbit(MouseButton button, const Vec2& at, const IVec2& size) {
    gesture_ = Gesture{NavigationMode::orbit, button, at, pivot(size), {camera_.target, false}};
}

void Navigation::change_mode(NavigationMode mode, const IVec2& size) {
    if (!gesture_ || gesture_->mode == mode) return;
    gesture_->mode = mode;
    prepare(*gesture_, size);
}

void Navigation::prepare(Gesture& gesture, const IVec2& size) {
    gesture.anchor = anchor_at(gesture.last, size);
    if (gesture.anchor.is_on_surface) touch(gesture.anchor.point);
    gesture.pivot = pivot(size);
    // What is at the depth of the target follows the cursor of a pan.
    if (gesture.mode == NavigationMode::pan) focus(gesture.pivot);
}

void Navigation::move_to(const Vec2& at, const IVec2& size) {
    if (!gesture_ || size.y <= 0) return;
    const Vec2 by = at - gesture_->last;
    gesture_->last = at;
    const double height = size.y;
    switch (gesture_->mode) {
        case NavigationMode::orbit: {
            const Vec2 angles = -kTurnPerHeight / height * by;
            orbit(angles, gesture_->pivot);
            break;
        }
        case NavigationMode::pan:
            pan_by(by, size);
            break;
        case NavigationMode::zoom:
            zoom_towards(gesture_->anchor, std::pow(kZoomPerHeight, by.y / height));
            break;
    }
}

std::optional<MouseButton> Navigation::button() const {
    if (!gesture_) return std::nullopt;
    return gesture_->button;
}

std::optional<NavigationMode> Navigation::mode() const {
    if (!gesture_) return std::nullopt;
    return gesture_->mode;
}

// --- Steps.

void Navigation::zoom(double notches, const Vec2& at, const IVec2& size) {
    const Anchor anchor = anchor_at(at, size);
    if (notches > 0.0 && anchor.is_on_surface) touch(anchor.point);
    zoom_towards(anchor, std::pow(kZoomPerNotch, std::clamp(notches, -kMostNotches, kMostNotches)));
}

void Navigation::pan(const Vec2& pixels, const IVec2& size) {
    focus(pivot(size));
    pan_by(pixels, size);
}

void Navigation::turn(double to_right, double upwards, const IVec2& size) {
    orbit({to_right, -upwards}, pivot(size));
}

void Navigation::orbit(const Vec2& angles, const Vec3& pivot) {
    const double length =
        glm::distance(camera_.eye, pivot) * (std::abs(angles.x) + std::abs(angles.y));
    follow([&, from = camera_](
               double part) { return orbited(from, part * angles.x, part * angles.y, pivot); },
           length);
}

void Navigation::pan_by(const Vec2& pixels, const IVec2& size) {
    const double length = glm::distance(camera_.eye, panned(camera_, pixels, size).eye);
    follow([&, from = camera_](double part) { return panned(from, part * pixels, size); }, length);
}

// Moves the camera along the path as far as the eye stays clear of the surface. length: of the
// eye's path, or more. In each step the eye moves by less than its distance from the surface, so
// that it cannot pass through. Where it is too near, also because of an edit, it may move away.
void Navigation::follow(const Path& path, double length) {
    if (camera_.is_orthographic() || length == 0.0) {
        camera_ = path(1.0);
        return;
    }
    const double least = kTurnClearance * kClosest * object_.diagonal();
    double part = 0.0, clearance = object_.distance(camera_.eye);
    for (int i = 0; i < kMostSteps && part < 1.0; ++i) {
        const double step = std::max(kSafeStep * (clearance - least), kShortStep * clearance);
        const double next = std::min(part + step / length, 1.0);
        const double there = object_.distance(path(next).eye);
        if (there < least && there <= clearance) break;
        part = next;
        clearance = there;
    }
    if (part > 0.0) camera_ = path(part);
}

// The point under the cursor: of the surface, else at the depth of the target.
Navigation::Anchor Navigation::anchor_at(const Vec2& at, const IVec2& size) {
    const Ray ray = camera_.ray_through(at, size);
    if (const std::optional<Vec3> hit = object_.first_hit(ray)) return {*hit, true};
    const double depth = glm::dot(camera_.target - ray.origin, camera_.forward());
    return {ray.at(depth / glm::dot(ray.direction, camera_.forward())), false};
}

bool Navigation::may_zoom(const Camera& from, double factor, const Anchor& anchor) {
    const Camera to = zoomed(from, factor, anchor.point);
    const double diagonal = object_.diagonal();
    if (factor >= 1.0) return to.distance() <= kFarthest * diagonal;
    if (to.distance() < kClosest * diagonal) return false;
    if (to.is_orthographic()) return true;
    const double clearance = std::min(object_.distance(to.eye), diagonal);
    return clearance >= kClosest * diagonal &&
           (anchor.is_on_surface || to.distance() >= kEmptyClearance * clearance);
}

// Zooms by the factor, or as far as is allowed. The eye moves along the ray of the cursor, at whose
// end the anchor is the first point of the surface. So it passes through nothing.
void Navigation::zoom_towards(const Anchor& anchor, double factor) {
    const Camera from = focused_on(camera_, anchor.point);
    if (factor == 1.0 || !from.is_valid()) return;
    double allowed = 1.0, last = factor;
    if (may_zoom(from, factor, anchor)) {
        allowed = factor;
    } else {
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = std::sqrt(allowed * last);
            (may_zoom(from, middle, anchor) ? allowed : last) = middle;
        }
    }
    const Camera to = zoomed(from, allowed, anchor.point);
    if (allowed != 1.0 && to.is_valid()) camera_ = to;
}

// Moves the target to the depth of the point, unless the eye is too near to it.
void Navigation::focus(const Vec3& point) {
    const double closest = kClosest * object_.diagonal();
    if (!camera_.is_orthographic() && camera_.depth(point) < closest) return;
    const Camera focused = focused_on(camera_, point);
    if (focused.is_valid()) camera_ = focused;
}

Vec3 Navigation::pivot(const IVec2& size) const {
    if (!pivot_) return camera_.target;
    const std::optional<Vec2> pixel = camera_.project(*pivot_, size);
    return pixel && is_inside(*pixel, size) ? *pivot_ : camera_.target;
}

// --- Views.

void Navigation::frame(std::span<const Vec3> points, const PictureArea& area,
                       const std::optional<Vec3>& direction) {
    const Vec3 from = oriented(up_axis_, direction.value_or(this->direction()));
    camera_ = fit(points, {.area = area,
                           .direction = from,
                           .up = up_vector(up_axis_),
                           .fov = camera_.fov,
                           .projection = camera_.projection});
    framed_ = camera_;
    Box box;
    for (const Vec3& point : points) box.include(point);
    pivot_.reset();
    if (!box.is_empty()) pivot_ = box.centre();
}

void Navigation::frame_again(std::span<const Vec3> points, const PictureArea& area) {
    const std::optional<Vec3> pivot = pivot_;
    frame(points, area);
    pivot_ = pivot;
}

void Navigation::look_from(const Vec3& direction, const IVec2& size) {
    const Vec3 pivot = this->pivot(size);
    const Camera from = camera_ == outside_ ? inside_ : camera_;
    camera_ = looking_from(from, oriented(up_axis_, direction), up_vector(up_axis_), pivot);
    leave_object(pivot);
}

// A view from another side may put the eye into the object. Then the camera moves back, so that the
// point keeps its pixel, until the eye is as far before the surface as it was before the point. The
// next view begins where the camera was, so that views can be changed to and fro.
void Navigation::leave_object(const Vec3& point) {
    inside_ = outside_ = camera_;
    const double distance = glm::distance(camera_.eye, point);
    if (camera_.is_orthographic() || distance == 0.0) return;
    const Vec3 backwards = (camera_.eye - point) / distance;
    const Vec3 beyond_object = camera_.eye + 2.0 * object_.diagonal() * backwards;
    const std::optional<Vec3> hit = object_.first_hit({beyond_object, -backwards});
    if (!hit) return;
    const double depth = glm::dot(*hit - point, backwards);
    if (depth < distance - kClosest * object_.diagonal()) return;
    outside_.eye += depth * backwards;
    outside_.target += depth * backwards;
    if (outside_.is_valid()) camera_ = outside_;
}

void Navigation::set_up_axis(UpAxis up, const IVec2& size) {
    const Vec3 direction = this->direction();
    up_axis_ = up;
    look_from(direction, size);
}

// The eye must not be within the object when an orthographic picture becomes a perspective one. It
// moves to the ray through the middle of the picture, before the first point of the surface there.
void Navigation::set_projection(Projection projection, const IVec2& size) {
    const std::optional<Vec3> hit = object_.first_hit(camera_.ray_through(0.5 * Vec2(size), size));
    focus(hit.value_or(pivot(size)));
    camera_.projection = projection;
}

}  // namespace pectin

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
// Moving the mouse over the window's height zooms by this factor.
constexpr double kZoomPerHeight = 8.0;
// Limits of the camera's distance, relative to the distance of the target from the origin. Beyond
// them the camera loses its precision.
constexpr double kMinDistance = 1e-9, kMaxDistance = 1e12;

constexpr std::array<InputReference, 7> kInputs{{
    {"Drag the background", "Rotates the view."},
    {"Middle or right button and drag", "Rotates the view, also over the object."},
    {"Shift+drag the background", "Pans the view."},
    {"Shift+middle or right button and drag", "Pans the view, also over the object."},
    {"Alt+right button and drag", "Pans the view."},
    {"Wheel", "Zooms to what is under the cursor."},
    {"Ctrl+middle button and drag", "Zooms."},
}};

Camera zoomed_within_limits(const Camera& camera, double factor) {
    const double distance = camera.distance() * factor;
    const double size = 1.0 + glm::length(camera.target);
    if (!(distance > kMinDistance * size && distance < kMaxDistance * size)) return camera;
    return zoomed(camera, factor);
}

}  // namespace

NavigationMode navigation_mode(MouseButton button, const Modifiers& modifiers) {
    if (button == MouseButton::middle && modifiers.control) return NavigationMode::zoom;
    const bool alt_pans = button == MouseButton::right && modifiers.alt;
    return modifiers.shift || alt_pans ? NavigationMode::pan : NavigationMode::orbit;
}

std::string_view navigation_hint(const Modifiers& modifiers) {
    if (modifiers.shift) return "Drag to move the object across the window.";
    return "Drag to turn the object, with Shift to move it, and turn the wheel to zoom.";
}

InputGroup navigation_inputs() { return {"View", kInputs, 2}; }

void Navigation::begin(NavigationMode mode, MouseButton button, const Vec2& at) {
    gesture_ = Gesture{mode, button, at};
}

void Navigation::move_to(const Vec2& at, const IVec2& size) {
    if (!gesture_ || size.y <= 0) return;
    const Vec2 by = at - gesture_->last;
    gesture_->last = at;
    const double height = size.y;
    switch (gesture_->mode) {
        case NavigationMode::orbit: {
            const Vec2 angles = -kTurnPerHeight / height * by;
            camera_ = orbited(camera_, angles.x, angles.y, camera_.target);
            break;
        }
        case NavigationMode::pan:
            camera_ = panned(camera_, by, size);
            break;
        case NavigationMode::zoom:
            camera_ = zoomed_within_limits(camera_, std::pow(kZoomPerHeight, by.y / height));
            break;
    }
}

std::optional<MouseButton> Navigation::button() const {
    if (!gesture_) return std::nullopt;
    return gesture_->button;
}

void Navigation::scroll(double amount, const Vec2& at, const IVec2& size) {
    const Camera nearer =
        zoomed_within_limits(camera_, std::pow(kZoomPerNotch, std::clamp(amount, -10.0, 10.0)));
    const double factor = nearer.distance() / camera_.distance();
    const Vec2 from_centre = at - 0.5 * Vec2(size);
    camera_ = panned(nearer, (1.0 - 1.0 / factor) * from_centre, size);
}

void Navigation::frame(std::span<const Vec3> points, double aspect, double fraction_of_height,
                       const std::optional<Vec3>& direction) {
    const Vec3 back = direction.value_or(camera_.eye - camera_.target);
    Camera fitted = fit(points, aspect, back, camera_.fov);
    fitted.up = {0.0, 1.0, 0.0};
    camera_ = zoomed(fitted, 1.0 / fraction_of_height);
}

}  // namespace pectin

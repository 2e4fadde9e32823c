// Orbiting, panning and zooming of the camera with the mouse.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "app/input_event.h"
#include "app/input_reference.h"
#include "geometry/camera.h"

namespace pectin {

enum class NavigationMode { orbit, pan, zoom };

// Returns the mode that a press begins which no tool takes.
NavigationMode navigation_mode(MouseButton button, const Modifiers& modifiers);
// One sentence about what a drag with the left button then does.
std::string_view navigation_hint(const Modifiers& modifiers);
// What the mouse does with the view, for help.
InputGroup navigation_inputs();

class Navigation {
  public:
    const Camera& camera() const { return camera_; }

    // --- A gesture of the mouse, from press to release.
    void begin(NavigationMode mode, MouseButton button, const Vec2& at);
    void move_to(const Vec2& at, const IVec2& size);
    void end() { gesture_.reset(); }
    bool is_active() const { return gesture_.has_value(); }
    // The button that began the gesture.
    std::optional<MouseButton> button() const;

    // Zooms in for a positive amount. The point under the cursor stays there.
    void scroll(double amount, const Vec2& at, const IVec2& size);

    // Moves the camera so that all points are visible, from `direction` or else from its present
    // direction. aspect: of the part of the window that shows them, which is centred in the window.
    void frame(std::span<const Vec3> points, double aspect, double fraction_of_height,
               const std::optional<Vec3>& direction = {});

  private:
    struct Gesture {
        NavigationMode mode;
        MouseButton button;
        Vec2 last;
    };

    Camera camera_;
    std::optional<Gesture> gesture_;
};

// Directions from the target to the eye.
inline constexpr Vec3 kFrontView{0.0, 0.0, 1.0};
inline constexpr Vec3 kRightView{1.0, 0.0, 0.0};
inline constexpr Vec3 kTopView{0.0, 1.0, 1e-4};  // a little to the front, so that +y is up

}  // namespace pectin

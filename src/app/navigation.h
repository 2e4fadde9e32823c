// Looking around: which mouse gesture turns, moves or nears the camera, and by how much.
#pragma once

#include <optional>
#include <span>

#include "app/input_event.h"
#include "geometry/camera.h"

namespace pectin {

enum class NavigationMode { orbit, pan, zoom };

// What a press means; nothing where it drags the surface.
std::optional<NavigationMode> navigation_mode(MouseButton button, const Modifiers& modifiers,
                                              bool on_surface);

class Navigation {
  public:
    const Camera& camera() const { return camera_; }

    // --- A gesture of the mouse: from press to release.
    void begin(NavigationMode mode, MouseButton button, const Vec2& at);
    void move_to(const Vec2& at, const IVec2& size);
    void end() { gesture_.reset(); }
    bool is_active() const { return gesture_.has_value(); }
    // The button that began the gesture.
    std::optional<MouseButton> button() const;

    // Up is nearer; what is under the cursor stays there.
    void scroll(double amount, const Vec2& at, const IVec2& size);

    // Shows all of the points from where the camera looks now, or from `direction`. aspect: of the
    // part of the window that they are to be seen in, which has its middle in the window's.
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

// Target to eye.
inline constexpr Vec3 kFrontView{0.0, 0.0, 1.0};
inline constexpr Vec3 kRightView{1.0, 0.0, 0.0};
inline constexpr Vec3 kTopView{0.0, 1.0, 1e-4};  // a little to the front: up stays +y

}  // namespace pectin

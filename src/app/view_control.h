// The view of the window: how mouse, wheel and actions move the camera, the part of the window that
// shows the object, and the axes in its corner.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/axes_gizmo.h"
#include "app/input_event.h"
#include "app/mouse_preset.h"
#include "app/navigation.h"
#include "app/preferences.h"
#include "app/tools/screen_box.h"
#include "app/workspace.h"

namespace pectin {

class ViewControl final : private NavigatedObject {
  public:
    // Both must outlive the control.
    ViewControl(Workspace& workspace, const Preferences& preferences)
        : workspace_(workspace), preferences_(preferences) {}
    ViewControl(const ViewControl&) = delete;  // its navigation refers to it

    const Camera& camera() const { return navigation_.camera(); }
    const IVec2& size() const { return size_; }  // of the window

    // --- Input. Positions are in window coordinates.
    void resize(const IVec2& size) { size_ = size; }
    // A press that moves the view also where tools would take it. Returns whether it was taken.
    bool press_before_tools(const event::Press& press, bool holds_space);
    // A press that no tool takes.
    void press(const event::Press& press);
    void move(const Vec2& at, const Modifiers& modifiers);
    void release(MouseButton button);
    void scroll(const event::Scroll& scroll, const Modifiers& modifiers);
    // Ends a gesture without what a click would do.
    void cancel();
    bool is_active() const { return navigation_.is_active(); }
    // One sentence about what a drag with the left button does, unless a tool takes it.
    std::string_view hint(const Vec2& at, const Modifiers& modifiers, bool holds_space) const;
    // Whether hint() also holds where a tool would take a press.
    bool has_priority(const Vec2& at, const Modifiers& modifiers, bool holds_space) const;

    // --- The part of the window that no panel covers. The projection stays centred in the window,
    // so that pictures of the window and picking need nothing but the camera; frame_all() places
    // the camera so that the object is in the middle of this part.
    // scale: of sizes, 1 on an ordinary screen.
    void set_free_area(const ScreenBox& area, double scale);
    // Frames all again if the area or the window has changed since frame_all() and the
    // camera has not moved. Cost: O(n) if so, else O(1). The object must not be in use.
    void follow_free_area();
    // The axes in the upper right corner of this part; nothing if it is too small.
    std::optional<AxesGizmo> axes() const;
    // The end of the axes under the cursor, or of the press that has not moved yet.
    std::optional<AxisEnd> axis_at(const Vec2& at) const;

    // --- Views. The object must not be in use by work in the background. Directions are those of
    // models with y up (see oriented()). Cost: O(n) where the object is framed.
    // Shows the whole object, with all control points of a cage, from its present direction or
    // another.
    void frame_all(const std::optional<Vec3>& direction = {});
    // Shows the whole object and these points from the direction of the first view, also after the
    // free part of the window has changed.
    void frame_with(std::span<const Vec3> others);
    // Turns the view about the point that was touched last. If the whole object, with a cage, was
    // visible and would not be, it is framed.
    void look_from(const Vec3& direction);
    // Looks from this end of an axis, or from the other end if the view looks from this one
    // already.
    void look_along(const AxisEnd& end);
    void turn(double degrees_to_right, double degrees_upwards);
    void zoom(double notches);  // towards the middle of the free part of the window
    void touch(const Vec3& point) { navigation_.touch(point); }

    Projection projection() const { return camera().projection; }
    void set_projection(Projection projection);
    UpAxis up_axis() const { return navigation_.up_axis(); }
    void set_up_axis(UpAxis up);
    // Frames a new object, with the axis up that its file and its box suggest.
    void begin_object();

  private:
    std::optional<Vec3> first_hit(const Ray& ray) override;
    double distance(const Vec3& point) override;
    double diagonal() const override;

    MousePreset preset() const { return preferences_.mouse; }
    ScreenBox free_area() const;
    PictureArea picture_area() const;
    bool shows(const std::vector<Vec3>& points) const;
    // The positions of the object's vertices, and the corners of a cage.
    std::vector<Vec3> points() const;
    std::vector<Vec3> points_to_frame() const;

    // A press on the axes, which becomes an orbit when the mouse moves.
    struct AxesPress {
        Vec2 at;
        std::optional<AxisEnd> end;
        bool has_moved = false;
    };

    Workspace& workspace_;
    const Preferences& preferences_;
    Navigation navigation_{*this};
    IVec2 size_{1280, 800};
    std::optional<ScreenBox> free_area_;
    double scale_ = 1.0;
    PictureArea framed_area_;   // of the last framing
    std::vector<Vec3> framed_;  // what it shows besides the object
    std::optional<AxesPress> axes_press_;
    bool began_with_alt_ = false;
};

}  // namespace pectin

// What the tools of the mouse (app/tools/) may use of the editor, and what they share with each
// other. They know nothing else of it.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "app/frame_figures.h"
#include "app/input_event.h"
#include "app/pins.h"
#include "app/view.h"
#include "app/workspace.h"
#include "ffd/brush_profile.h"

namespace pectin {

// What the radius of the brush is measured in, and so what it keeps to.
enum class RadiusUnit {
    share,  // of the diagonal of the object's box: other objects get a radius of their own size
    model,  // the model's units
    screen  // pixels: the radius at the cursor follows the zoom
};
struct BrushSize {
    RadiusUnit unit = RadiusUnit::share;
    double share = kAutoRadius;  // of the radius that the session has
    double pixels = 100.0;       // used if the unit is the screen
};
struct Range {
    double least = 0.0, most = 0.0;
    double clamped(double value) const { return std::clamp(value, least, most); }
};

// A drag that has ended, so that it can be repeated elsewhere.
struct LastDrag {
    command::Drag drag;
    Vec3 normal{0.0};  // of the surface where the drag began
};

struct Display {
    bool wireframe = false, levels = false;
    // Whether the lattice is also shown between drags. The control points of a cage can then be
    // dragged.
    bool lattice = false;
    bool drag_lattice = false;  // whether drags show the lattice that they deform
    bool symmetry_plane = true;
};

// The cursor, and the keys that are held with it.
struct Pointer {
    Vec2 at{0.0};  // in window coordinates
    Modifiers modifiers{};
    bool is_in_viewport = false;  // over the window and not over its panels
    // Whether drags of the surface go along its normal: N is held, or Alt, unless that moves the
    // view (see mouse_preset.h).
    bool along_normal = false;
};

class ToolContext {
  public:
    virtual ~ToolContext() = default;

    // --- Settings that tools follow, and that panels and actions change.
    Display display{};
    DragOptions drag_options{.connected = true, .fold_free = true};
    double drag_strength = 1.0;  // how much of the cursor's way a dragged point follows
    bool sets_pins = false;      // whether a click on the surface sets or removes a pin
    // The radius while it is being set with the mouse, in the unit of the radius.
    std::optional<double> radius_being_set{};
    // The same while a control of a panel is held, which sets it anew in every layout.
    std::optional<double> radius_preview{};
    std::optional<LastDrag> last_drag{};

    // --- The object.
    virtual Workspace& workspace() = 0;
    virtual const Workspace& workspace() const = 0;
    const Session& session() const { return workspace().session(); }
    virtual Pins& pins() = 0;
    virtual const Pins& pins() const = 0;
    // The figures that a drag records.
    virtual FrameFigures& drag_figures() = 0;
    // Whether a tool drags the object, or the end of its drag is being worked on.
    virtual bool is_dragging() const = 0;
    // Whether there is work in the background. Only settings of the session may be used meanwhile.
    virtual bool is_working() const = 0;

    // --- The cursor.
    virtual View view() const = 0;
    virtual const Pointer& pointer() const = 0;
    // The point of the surface under the cursor in the last frame; nothing during a drag, and where
    // a tool shows something else under the cursor.
    virtual const std::optional<Pick>& hover() const = 0;
    Ray ray_through_cursor() const { return view().ray_through(pointer().at); }
    // Precondition: not is_working().
    std::optional<Pick> pick_at_cursor();
    // Returns the pick, moved onto the plane of symmetry if it is near. There it could hardly be
    // moved apart from its image, since the two would be nearly one constraint.
    Pick snapped_to_symmetry_plane(Pick pick) const;

    // --- The brush and the cage.
    // The brush's radius in the model's units, also while it is being set. If its unit is the
    // screen, it is that at the point under the cursor, or else at the point the camera looks at.
    double radius() const;
    bool is_setting_radius() const { return radius_being_set || radius_preview; }
    // Sets the brush's radius, clamped to the range from min_radius() to max_radius(), which
    // follows from the object's size.
    virtual void set_radius(double radius) = 0;
    double min_radius() const;
    double max_radius() const;
    // If the unit is the screen: sets the radius of the session to what it is at this point.
    // Precondition: there is no drag.
    virtual void use_radius_at(const Vec3& point) = 0;

    // --- The radius in its own unit.
    const BrushSize& brush_size() const { return brush_size_; }
    double radius_value() const;
    Range radius_range() const;
    virtual void set_radius_value(double value) = 0;
    // Keeps the radius that there is.
    virtual void set_radius_unit(RadiusUnit unit) = 0;

    // How the brush's drags fall off.
    const BrushProfile& brush_profile() const;
    // Whether drags use a cage instead of the brush.
    bool has_cage() const { return session().lattice_settings().cage.has_value(); }
    // Takes note of a point of the surface that the user has dragged. Orbits turn about it.
    virtual void touch(const Vec3& point) = 0;
    // The cage, if its control points are shown and can be dragged.
    std::optional<Lattice> editable_cage() const;

  protected:
    // A radius in the model's units, clamped to its range.
    double model_radius(double value, const Vec3& at) const;
    double pixel_length_at_cursor() const;

    BrushSize brush_size_;

  private:
    mutable std::unique_ptr<BrushProfile> profile_;  // of the last call
};

}  // namespace pectin

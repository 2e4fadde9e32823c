// What the tools of the mouse (app/tools/) may use of the editor, and what they share with each
// other. They know nothing else of it.
#pragma once

#include <optional>

#include "app/frame_figures.h"
#include "app/input_event.h"
#include "app/pins.h"
#include "app/view.h"
#include "app/workspace.h"

namespace pectin {

struct Display {
    bool wireframe = false, levels = false;
    // Whether the lattice is also shown between drags. The control points of a cage can then be
    // dragged.
    bool lattice = false;
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
    bool sets_pins = false;  // whether a click on the surface sets or removes a pin
    // The radius while it is being set with the mouse.
    std::optional<double> radius_being_set{};

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
    // The brush's radius, also while it is being set with the mouse.
    double radius() const { return radius_being_set.value_or(workspace().radius()); }
    bool is_setting_radius() const { return radius_being_set.has_value(); }
    // Sets the brush's radius, clamped to the range from min_radius() to max_radius(). The range
    // follows from the object's size.
    virtual void set_radius(double radius) = 0;
    double min_radius() const;
    double max_radius() const;
    // Takes note of a point of the surface that the user has dragged. Orbits turn about it.
    virtual void touch(const Vec3& point) = 0;
    // The cage, if its control points are shown and can be dragged.
    std::optional<Lattice> editable_cage() const;
};

}  // namespace pectin

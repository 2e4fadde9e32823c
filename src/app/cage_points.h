// The control points of the cage under the mouse: found, selected, dragged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input_event.h"
#include "app/view.h"
#include "session/session.h"

namespace pectin {

// A press on a control point selects it, with Shift too; moving on takes all that are selected
// along, in the plane of the picture. Ctrl and a drag anywhere selects what is in a box, with Shift
// too. With symmetry on, those on the other side go the mirrored way. All indices here are those of
// Lattice, from 0, margins included.
class CagePoints {
  public:
    // --- Before a press. surface: what the cursor meets of the object.
    // The control point under the cursor that is drawn and that the surface does not hide.
    std::optional<IVec3> under(const Session& session, const View& view, const Vec2& at,
                               const std::optional<Pick>& surface) const;
    void set_hovered(const std::optional<IVec3>& hovered) { hovered_ = hovered; }
    // Whether it has begun something. Precondition: there is a cage.
    bool press(const Session& session, const View& view, const Vec2& at, const Modifiers& modifiers,
               const std::optional<Pick>& surface);

    // --- Between press and release.
    bool is_active() const { return held_ || box_; }
    bool is_dragging() const { return held_ && held_->has_begun; }
    void move_to(const Vec2& at);
    // Takes the control points to the cursor, once it has gone a little. Whether the object changed
    // is in the session's dirty elements. A refusal leaves the frame before.
    std::optional<std::string> update_drag(Session& session, const View& view);
    // What it came to, if anything moved.
    std::optional<command::Control> release(Session& session, const View& view);
    void cancel(Session& session);

    // Those of another cage mean nothing.
    void forget_others(const std::optional<Lattice>& cage);
    void select_none() { selected_.clear(); }

    // --- For who shows them.
    const std::vector<IVec3>& selected() const { return selected_; }
    const std::optional<IVec3>& hovered() const { return hovered_; }
    struct ScreenBox {
        Vec2 from{0.0}, to{0.0};
    };
    const std::optional<ScreenBox>& box() const { return box_; }
    // Of all control points, as Lattice::control_index has them. Precondition: is_dragging().
    std::vector<Vec3> displacements(const Session& session) const;

  private:
    struct Held {
        IVec3 index;
        Vec2 pressed_at, at;
        bool was_selected;
        bool has_begun = false;
        std::vector<IVec3> moving{};
        Vec3 by{0.0};  // of the last frame
    };
    bool is_selected(const IVec3& index) const;
    void toggle(const IVec3& index);
    void select_in_box(const Session& session, const View& view);
    std::optional<Vec3> motion(const Session& session, const View& view) const;
    std::vector<IVec3> moving_with(const Session& session, const IVec3& grabbed) const;

    std::vector<IVec3> selected_;  // each once
    std::optional<IVec3> hovered_;
    IVec3 counts_{0};  // of the cage that they are of
    std::optional<Held> held_;
    std::optional<ScreenBox> box_;
    bool box_adds_ = false;
};

}  // namespace pectin

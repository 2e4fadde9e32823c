// Selection and dragging of a cage's control points with the mouse.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input_event.h"
#include "app/tools/drag_constraint.h"
#include "app/tools/screen_box.h"
#include "app/view.h"
#include "session/session.h"

namespace pectin {

// A press on a control point selects it; with Shift it is added to the selection. Moving the mouse
// then drags all selected points parallel to the view plane. Ctrl and a drag anywhere select the
// points in a box; with Shift they are added. With symmetry, the mirrored points move as images.
// All indices are those of Lattice: they begin at 0 and include the margins.
class CagePoints {
  public:
    // --- Before a press. surface: the point of the object under the cursor, if any.
    // Returns the visible control point under the cursor that is not hidden by the surface.
    std::optional<IVec3> find_at(const Session& session, const View& view, const Vec2& at,
                                 const std::optional<Pick>& surface) const;
    void set_hovered(const std::optional<IVec3>& hovered) { hovered_ = hovered; }
    // Returns whether the press has begun a drag or a box. Precondition: there is a cage.
    bool press(const Session& session, const View& view, const Vec2& at, const Modifiers& modifiers,
               const std::optional<Pick>& surface);

    // --- Between press and release.
    bool is_active() const { return grabbed_ || box_; }
    bool is_dragging() const { return grabbed_ && grabbed_->has_begun; }
    void move_to(const Vec2& at);
    // Moves the selected control points with the cursor, once it is farther from the press than a
    // click allows. The session's dirty elements say whether the object has changed. After a
    // refusal the points stay where they were in the frame before.
    Done update_drag(Session& session, const View& view);
    // Keys for the constraint of the drag, which ends with it. Return whether the key or character
    // is one of the constraint's; the drag then begins even if the cursor has not moved.
    bool press_key(Key key, bool shift) { return grabbed_ && constraint_.press(key, shift); }
    bool type(unsigned int character) { return grabbed_ && constraint_.type(character); }
    const DragConstraint& constraint() const { return constraint_; }
    // The displacement in the last frame. Precondition: is_dragging().
    const Vec3& displacement() const { return grabbed_->displacement; }
    // Where the grabbed control point is now. Precondition: is_dragging().
    Vec3 grabbed_position(const Session& session) const;
    // Ends a click or a box. Precondition: not is_dragging().
    void release(const Session& session, const View& view);
    // Forgets the drag or the box. The session has to end or cancel its drag.
    void end() {
        grabbed_.reset();
        box_.reset();
        constraint_.clear();
    }

    // Clears the selection if the cage has other counts than in the last call.
    void reset_for(const std::optional<Lattice>& cage);
    void clear_selection() { selected_.clear(); }

    // --- State to display.
    const std::vector<IVec3>& selected() const { return selected_; }
    const std::optional<IVec3>& hovered() const { return hovered_; }
    const std::optional<ScreenBox>& box() const { return box_; }
    // The displacements of all control points, in the order of Lattice::control_index().
    // Precondition: is_dragging().
    std::vector<Vec3> displacements(const Session& session) const;

  private:
    struct Grabbed {
        IVec3 index;
        Vec2 pressed_at, at;
        bool was_selected;
        bool has_begun = false;
        std::vector<IVec3> moving{};
        Vec3 displacement{0.0};  // in the last frame
    };
    bool is_selected(const IVec3& index) const;
    void toggle(const IVec3& index);
    void select_in_box(const Session& session, const View& view);
    Done begin_drag(Session& session);
    std::optional<Vec3> cursor_displacement(const View& view, const Vec3& rest) const;
    std::optional<Vec3> wanted_displacement(const Session& session, const View& view);
    std::vector<IVec3> points_to_move(const Session& session, const IVec3& grabbed) const;

    std::vector<IVec3> selected_;  // without repetition
    std::optional<IVec3> hovered_;
    IVec3 counts_{0};  // of the cage to which the selection belongs
    std::optional<Grabbed> grabbed_;
    DragConstraint constraint_;
    std::optional<ScreenBox> box_;
    bool box_adds_ = false;
};

}  // namespace pectin

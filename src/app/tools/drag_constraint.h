// What keys say about a drag while it is going on: an axis or a plane that it keeps to, and a
// distance that is typed.
#pragma once

#include <optional>
#include <string>

#include "app/input_event.h"
#include "geometry/camera.h"

namespace pectin {

class DragConstraint {
  public:
    // X, Y and Z keep the drag to that axis, and with Shift to the plane across it; the same key
    // again takes it back. Backspace deletes the last character of the distance. Returns whether
    // the key is one of these.
    bool press(Key key, bool shift);
    // Digits, a point or comma, and a minus, which changes the sign, are the distance. Returns
    // whether the character is one of these.
    bool type(unsigned int character);
    void clear() { *this = {}; }

    bool is_active() const { return axis_ || is_typing(); }
    // The axis of world space that the drag keeps to, or with is_plane() the one across the plane.
    const std::optional<int>& axis() const { return axis_; }
    bool is_plane() const { return is_plane_; }
    bool is_typing() const { return !digits_.empty() || is_negative_; }
    // The distance that was typed, in the model's units; nothing if there is no digit yet.
    std::optional<double> distance() const;

    // The displacement after this constraint. cursor: the displacement that follows the cursor,
    // within the axis or plane. A typed distance goes along the axis, or else along the direction
    // that the drag had when the typing began. If it was shorter than `start` then, that is the
    // direction. Precondition: start is not 0.
    Vec3 displacement(const Vec3& cursor, const Vec3& start);

    // Such as "Distance along X: 0.25". displacement: the present one.
    std::string description(const Vec3& displacement) const;

  private:
    std::optional<int> axis_;
    bool is_plane_ = false, is_negative_ = false;
    std::string digits_;
    std::optional<Vec3> direction_;  // while a distance is typed without an axis
};

// Whether a key of this event may be for a constraint: no shortcut, and only Backspace repeats.
bool is_constraint_key(const event::KeyDown& key);
// What the status line shows while there is a constraint.
std::string hint_of(const DragConstraint& constraint, const Vec3& displacement);

}  // namespace pectin

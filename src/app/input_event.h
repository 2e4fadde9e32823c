// Events of mouse, keyboard and window, independent of any window system.
//
// Positions are in window coordinates: from the top left corner, in the units of the window's size.
// On screens with small pixels these may be larger than pixels.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "geometry/camera.h"

namespace pectin {

struct Modifiers {
    bool shift = false, control = false, alt = false;
    bool operator==(const Modifiers&) const = default;
};

enum class MouseButton { left, middle, right };

// Keys by their label in the present keyboard layout. Letters and digits are their ASCII capitals,
// such as Key{'Z'}.
enum class Key : int {
    none = 0,
    escape = 256,
    enter,
    tab,
    space,
    backspace,
    insert,
    delete_key,
    left,
    right,
    up,
    down,
    home,
    end,
    page_up,
    page_down,
    keypad_1,
    keypad_2,
    keypad_3,
    keypad_4,
    keypad_5,
    keypad_6,
    keypad_7,
    keypad_8,
    keypad_add,
    keypad_subtract,
    f1,
    f3,
    f10
};

// The shape of the mouse cursor.
enum class CursorShape { arrow, text, hand, resize_horizontally, resize_vertically };

namespace event {

struct Press {
    MouseButton button = MouseButton::left;
    Vec2 at{0.0};
    Modifiers modifiers{};
};
struct Release {
    MouseButton button = MouseButton::left;
    Vec2 at{0.0};
    Modifiers modifiers{};
};
// Also sent when a modifier is pressed or released while the cursor stays.
struct MouseMove {
    Vec2 at{0.0};
    Modifiers modifiers{};
};
struct Leave {};  // the cursor has left the window
// Of a wheel, in notches, or of two fingers, in fractions of notches.
struct Scroll {
    double amount = 0.0;  // up is positive
    Vec2 at{0.0};
    double sideways = 0.0;  // to the left is positive
};
struct KeyDown {
    Key key = Key::none;
    Modifiers modifiers{};
    bool is_repeat = false;
};
struct KeyUp {
    Key key = Key::none;
};
struct Character {
    unsigned int code = 0;  // Unicode code point
};
struct Drop {
    std::vector<std::string> paths{};
};
struct Resize {
    IVec2 size{0};
};
struct Focus {
    bool gained = false;  // if false, it was lost: keys are then released without a KeyUp
};
struct Close {};

}  // namespace event

using InputEvent = std::variant<event::Press, event::Release, event::MouseMove, event::Leave,
                                event::Scroll, event::KeyDown, event::KeyUp, event::Character,
                                event::Drop, event::Resize, event::Focus, event::Close>;

}  // namespace pectin

// What a person does with mouse and keyboard, apart from any window system.
//
// Places are in window coordinates: from the top left corner, in the units that the window's size
// is given in (pixels, or larger than pixels on screens of small ones).
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

// Keys by what is written on them in the present layout: letters and digits are their ASCII
// capitals, as in Key{'Z'}.
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
    keypad_3,
    keypad_7
};

// The shape of the cursor over what lies under it.
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
// Also sent where the cursor stays and a modifier is pressed or released.
struct Move {
    Vec2 at{0.0};
    Modifiers modifiers{};
};
struct Leave {};  // the cursor is over the window no more
struct Scroll {
    double amount = 0.0;  // notches, up is positive
    Vec2 at{0.0};
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
    unsigned int code = 0;  // Unicode
};
struct Drop {
    std::vector<std::string> paths{};
};
struct Resize {
    IVec2 size{0};
};
struct Focus {
    bool gained = false;  // else lost: keys are released without a KeyUp from now on
};
struct Close {};

}  // namespace event

using InputEvent = std::variant<event::Press, event::Release, event::Move, event::Leave,
                                event::Scroll, event::KeyDown, event::KeyUp, event::Character,
                                event::Drop, event::Resize, event::Focus, event::Close>;

}  // namespace pectin

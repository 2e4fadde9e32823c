// Actions of keys and menus, and the keys for them.
#pragma once

#include <optional>
#include <string>

#include "app/input_event.h"

namespace pectin {

enum class Action {
    open,
    save,
    save_as,
    export_obj,
    save_picture,
    quit,
    undo,
    redo,
    frame_all,
    view_front,
    view_right,
    view_top,
    toggle_wireframe,
    toggle_lattice,
    toggle_levels,
    toggle_symmetry,
    toggle_pin,  // under the cursor
    remove_pins,
    smaller_radius,
    larger_radius,
};

// Alt is ignored, since no shortcut contains it.
std::optional<Action> action_for(Key key, const Modifiers& modifiers);
// For shortcuts that are a character, wherever the keyboard layout has it.
std::optional<Action> action_for(unsigned int character);

// The shortcut as menus show it, such as "Ctrl+Shift+S"; empty if there is none.
std::string shortcut_label(Action action);

}  // namespace pectin

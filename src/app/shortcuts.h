// What can be asked of the window by key or menu, and the keys that ask for it.
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

// Alt is not looked at: it is part of no shortcut.
std::optional<Action> action_for(Key key, const Modifiers& modifiers);
// For those that a character asks for, wherever a layout has it.
std::optional<Action> action_for(unsigned int character);

// As a menu shows it, as in "Ctrl+Shift+S"; empty where there is none.
std::string shortcut_label(Action action);

}  // namespace pectin

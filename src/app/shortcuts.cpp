#include "app/shortcuts.h"

#include <array>

namespace pectin {
namespace {

constexpr Modifiers kPlain{};
constexpr Modifiers kControl{.control = true};
constexpr Modifiers kControlShift{.shift = true, .control = true};

struct Shortcut {
    Key key;
    Modifiers modifiers;
    Action action;
    const char* label;
};

// If an action has several shortcuts, menus show the first.
constexpr std::array kShortcuts{
    Shortcut{Key{'O'}, kControl, Action::open, "Ctrl+O"},
    Shortcut{Key{'S'}, kControl, Action::save, "Ctrl+S"},
    Shortcut{Key{'S'}, kControlShift, Action::save_as, "Ctrl+Shift+S"},
    Shortcut{Key{'E'}, kControl, Action::export_obj, "Ctrl+E"},
    Shortcut{Key{'Q'}, kControl, Action::quit, "Ctrl+Q"},
    Shortcut{Key{'Z'}, kControl, Action::undo, "Ctrl+Z"},
    Shortcut{Key{'Z'}, kControlShift, Action::redo, "Ctrl+Shift+Z"},
    Shortcut{Key{'Y'}, kControl, Action::redo, "Ctrl+Y"},
    Shortcut{Key::home, kPlain, Action::frame_all, "Home"},
    Shortcut{Key::keypad_1, kPlain, Action::view_front, "Keypad 1"},
    Shortcut{Key::keypad_3, kPlain, Action::view_right, "Keypad 3"},
    Shortcut{Key::keypad_7, kPlain, Action::view_top, "Keypad 7"},
    Shortcut{Key{'X'}, kPlain, Action::toggle_symmetry, "X"},
    Shortcut{Key{'P'}, kPlain, Action::toggle_pin, "P"},
    Shortcut{Key{'W'}, kPlain, Action::toggle_wireframe, "W"},
    Shortcut{Key{'L'}, kPlain, Action::toggle_lattice, "L"},
    Shortcut{Key{'V'}, kPlain, Action::toggle_levels, "V"},
};

struct CharacterShortcut {
    unsigned int character;
    Action action;
    const char* label;
};

constexpr std::array kCharacterShortcuts{
    CharacterShortcut{'[', Action::smaller_radius, "["},
    CharacterShortcut{']', Action::larger_radius, "]"},
    CharacterShortcut{'.', Action::frame_all, "."},
};

}  // namespace

std::optional<Action> action_for(Key key, const Modifiers& modifiers) {
    for (const Shortcut& shortcut : kShortcuts) {
        if (shortcut.key == key && shortcut.modifiers.shift == modifiers.shift &&
            shortcut.modifiers.control == modifiers.control) {
            return shortcut.action;
        }
    }
    return std::nullopt;
}

std::optional<Action> action_for(unsigned int character) {
    for (const CharacterShortcut& shortcut : kCharacterShortcuts) {
        if (shortcut.character == character) return shortcut.action;
    }
    return std::nullopt;
}

std::string shortcut_label(Action action) {
    for (const Shortcut& shortcut : kShortcuts) {
        if (shortcut.action == action) return shortcut.label;
    }
    for (const CharacterShortcut& shortcut : kCharacterShortcuts) {
        if (shortcut.action == action) return shortcut.label;
    }
    return {};
}

}  // namespace pectin

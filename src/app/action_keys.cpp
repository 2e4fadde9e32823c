// The keys of actions, and what menus and tooltips say about them.

#include <algorithm>

#include "app/actions.h"

namespace pectin {
namespace {

template <typename Matches>
std::optional<Action> find_action(const Matches& matches) {
    for (const ActionInfo& info : all_actions()) {
        if (std::ranges::any_of(info.shortcuts, matches)) return info.action;
    }
    return std::nullopt;
}

std::string key_name(const Shortcut& shortcut) {
    if (shortcut.character != 0) return std::string(1, shortcut.character);
    switch (shortcut.key) {
        case Key::tab:
            return "Tab";
        case Key::home:
            return "Home";
        case Key::keypad_1:
            return "Keypad 1";
        case Key::keypad_2:
            return "Keypad 2";
        case Key::keypad_3:
            return "Keypad 3";
        case Key::keypad_4:
            return "Keypad 4";
        case Key::keypad_5:
            return "Keypad 5";
        case Key::keypad_6:
            return "Keypad 6";
        case Key::keypad_7:
            return "Keypad 7";
        case Key::keypad_8:
            return "Keypad 8";
        case Key::keypad_add:
            return "Keypad +";
        case Key::keypad_subtract:
            return "Keypad -";
        case Key::f10:
            return "F10";
        case Key::f1:
            return "F1";
        case Key::f3:
            return "F3";
        default:
            return std::string(1, static_cast<char>(shortcut.key));
    }
}

// The menu that has this one as a submenu, or itself.
Menu parent_of(Menu menu) {
    const auto actions = all_actions();
    const auto row = std::ranges::find_if(
        actions, [menu](const ActionInfo& info) { return info.submenu_before == menu; });
    return row == actions.end() ? menu : row->menu;
}

}  // namespace

const char* menu_title(Menu menu) {
    switch (menu) {
        case Menu::file:
            return "File";
        case Menu::new_object:
            return "New";
        case Menu::edit:
            return "Edit";
        case Menu::undo_memory:
            return "Memory for undo";
        case Menu::view:
            return "View";
        case Menu::viewpoint:
            return "Viewpoint";
        case Menu::navigation:
            return "Navigation";
        case Menu::tools:
            return "Tools";
        case Menu::help:
            return "Help";
        case Menu::examples:
            return "Examples";
    }
    return "";
}

Menu top_menu(Menu menu) {
    const Menu parent = parent_of(menu);
    return parent == menu ? menu : top_menu(parent);
}

std::string menu_path(Action action) {
    Menu menu = info_of(action).menu;
    std::string path = menu_title(menu);
    for (Menu parent = parent_of(menu); parent != menu; parent = parent_of(menu)) {
        path = std::string(menu_title(parent)) + " > " + path;
        menu = parent;
    }
    return path;
}

std::optional<Action> action_for(Key key, const Modifiers& modifiers) {
    if (key == Key::none) return std::nullopt;
    return find_action([&](const Shortcut& shortcut) {
        return shortcut.key == key && shortcut.modifiers.shift == modifiers.shift &&
               shortcut.modifiers.control == modifiers.control;
    });
}

std::optional<Action> action_for(unsigned int character) {
    if (character == 0) return std::nullopt;
    return find_action([&](const Shortcut& shortcut) {
        return static_cast<unsigned char>(shortcut.character) == character;
    });
}

std::string label_of(const Shortcut& shortcut) {
    if (!shortcut.exists()) return {};
    return std::string(shortcut.modifiers.control ? "Ctrl+" : "") +
           (shortcut.modifiers.shift ? "Shift+" : "") + key_name(shortcut);
}

std::string shortcut_label(Action action) { return label_of(info_of(action).shortcuts.front()); }

std::string shortcut_labels(Action action) {
    std::string labels;
    for (const Shortcut& shortcut : info_of(action).shortcuts) {
        if (shortcut.exists()) labels += (labels.empty() ? "" : ", ") + label_of(shortcut);
    }
    return labels;
}

std::string tooltip_with_shortcuts(Action action) {
    std::string text = info_of(action).tooltip;
    const std::string labels = shortcut_labels(action);
    if (!labels.empty()) text.insert(text.size() - 1, " (" + labels + ")");
    return text;
}

}  // namespace pectin

// What a key, an entry of a menu or a button can do: one table of names, menus, keys, tooltips and
// effects. Menus, buttons, tooltips and the handling of keys read it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "app/input_event.h"

namespace pectin {

class Editor;

// In the order of the table, which is also the order in the menus.
enum class Action {
    new_sphere,
    new_cube,
    new_plane,
    new_torus,
    new_cylinder,
    open,
    save,
    save_as,
    save_picture,
    quit,
    undo,
    redo,
    toggle_symmetry,
    remove_pins,
    readapt,
    bake,
    frame_all,
    view_front,
    view_back,
    view_right,
    view_left,
    view_top,
    view_bottom,
    turn_left,
    turn_right,
    turn_up,
    turn_down,
    zoom_in,
    zoom_out,
    toggle_orthographic,
    toggle_z_up,
    navigate_as_blender,
    navigate_as_maya,
    navigate_as_zbrush,
    toggle_wireframe,
    toggle_lattice,
    toggle_levels,
    toggle_drag_lattice,
    toggle_symmetry_plane,
    toggle_panels,
    toggle_light_theme,
    larger_text,
    smaller_text,
    normal_text,
    open_menus,
    use_brush,
    use_cage,
    toggle_pinning,  // whether clicks set pins
    toggle_pin,      // under the cursor
    fit_cage,
    toggle_connected,
    toggle_fold_free,
    repeat_drag,  // at the point under the cursor
    smaller_radius,
    larger_radius,
    show_inputs,
    show_actions,
    example_nose,
    example_elephant,
    example_cage,
    show_reference,
    show_about,  // must stay the last one
};
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(Action::show_about) + 1;

enum class Menu {
    file,
    new_object,
    edit,
    undo_memory,
    view,
    viewpoint,
    navigation,
    tools,
    help,
    examples
};
// The menus of the menu bar, from left to right. The others are submenus.
inline constexpr std::array kMenuBar{Menu::file, Menu::edit, Menu::view, Menu::tools, Menu::help};

// A key with modifiers, or a character wherever the keyboard layout has it. Alt is ignored, since
// no shortcut contains it.
struct Shortcut {
    Key key = Key::none;
    Modifiers modifiers{};
    char character = 0;

    bool exists() const { return key != Key::none || character != 0; }
    bool operator==(const Shortcut&) const = default;
};

struct ActionInfo {
    Action action{};
    const char* name = "";  // as menus and panels show it
    Menu menu = Menu::file;
    // What the menu has before this entry: a submenu, and then a separator.
    std::optional<Menu> submenu_before{};
    bool begins_group = false;
    std::array<Shortcut, 3> shortcuts{};  // menus show the first
    bool repeats = false;                 // while the key is held
    const char* tooltip = "";             // one sentence
    bool (*is_enabled)(const Editor&) = nullptr;
    const char* needs = "";                  // what to do before it is enabled, or why it is not
    bool (*is_on)(const Editor&) = nullptr;  // null if the action switches nothing on and off
    bool is_choice = false;                  // one of several: it is on until another is performed
    // What it does. Precondition: is_enabled().
    void (*perform)(Editor&) = nullptr;
};

std::span<const ActionInfo, kActionCount> all_actions();
const ActionInfo& info_of(Action action);

const char* menu_title(Menu menu);
// The menu of the menu bar that has this menu as a submenu, or is this menu.
Menu top_menu(Menu menu);
// Where the action is found, such as "File > New".
std::string menu_path(Action action);

std::optional<Action> action_for(Key key, const Modifiers& modifiers);
std::optional<Action> action_for(unsigned int character);

// The shortcut as menus show it, such as "Ctrl+Shift+S"; empty if there is none.
std::string label_of(const Shortcut& shortcut);
std::string shortcut_label(Action action);
// All shortcuts of the action, separated by commas.
std::string shortcut_labels(Action action);
// The tooltip, with all shortcuts in brackets before its full stop.
std::string tooltip_with_shortcuts(Action action);

}  // namespace pectin

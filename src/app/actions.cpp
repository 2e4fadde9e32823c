#include "app/actions.h"

#include <algorithm>

#include "app/editor.h"
#include "app/tools/pin_tool.h"
#include "app/view_actions.h"

namespace pectin {
namespace {

using Kind = command::Shape::Kind;

// The brackets change the brush's radius by this factor.
constexpr double kRadiusStep = 1.12;

constexpr Shortcut plain(char letter) { return {.key = Key{letter}}; }
constexpr Shortcut control(char letter) {
    return {.key = Key{letter}, .modifiers = {.control = true}};
}
constexpr Shortcut control_shift(char letter) {
    return {.key = Key{letter}, .modifiers = {.shift = true, .control = true}};
}
constexpr Shortcut typed(char character) { return {.character = character}; }

// --- When an action is enabled. During work in the background only settings of the session may be
// read, and the figures of the workspace.

bool always(const Editor&) { return true; }

// If the limit of the history has dropped steps, undo says so.
bool can_undo(const Editor& editor) {
    const ObjectFigures object = editor.workspace().object_figures();
    return object.undo_steps > 0 || object.lost_undo_steps > 0;
}

bool can_redo(const Editor& editor) { return editor.workspace().object_figures().redo_steps > 0; }
bool is_refined(const Editor& editor) { return editor.workspace().object_figures().is_refined; }
bool has_pins(const Editor& editor) { return !editor.pins().is_empty(); }
bool has_cursor(const Editor& editor) { return editor.pointer().is_in_viewport; }

bool has_symmetry(const Editor& editor) { return editor.session().symmetry().has_value(); }

// --- What an action does, where it is more than one call.

template <Action kAction>
void perform_on_file(Editor& editor) {
    editor.document().perform(kAction);
}

template <Kind kKind, int kResolution>
void new_shape(Editor& editor) {
    editor.document().new_shape(kKind, kResolution);
}

template <bool Display::*kSetting>
bool shows(const Editor& editor) {
    return editor.display.*kSetting;
}

template <bool Display::*kSetting>
void toggle(Editor& editor) {
    editor.display.*kSetting = !(editor.display.*kSetting);
}

template <bool DragOptions::*kOption>
bool drags(const Editor& editor) {
    return editor.drag_options.*kOption;
}

template <bool DragOptions::*kOption>
void toggle(Editor& editor) {
    editor.drag_options.*kOption = !(editor.drag_options.*kOption);
}

// Actions before those that move the view, and after them.
constexpr std::array<ActionInfo, kFirstViewAction> kEarlierActions{{
    // --- New objects.
    {.action = Action::new_sphere,
     .name = "Sphere",
     .menu = Menu::new_object,
     .tooltip = "Begins with a new sphere.",
     .is_enabled = always,
     .perform = new_shape<Kind::sphere, 4>},
    {.action = Action::new_cube,
     .name = "Cube",
     .menu = Menu::new_object,
     .tooltip = "Begins with a new cube.",
     .is_enabled = always,
     .perform = new_shape<Kind::cube, 16>},
    {.action = Action::new_plane,
     .name = "Plane",
     .menu = Menu::new_object,
     .tooltip = "Begins with a new square in a plane.",
     .is_enabled = always,
     .perform = new_shape<Kind::plane, 32>},
    {.action = Action::new_torus,
     .name = "Torus",
     .menu = Menu::new_object,
     .tooltip = "Begins with a new torus.",
     .is_enabled = always,
     .perform = new_shape<Kind::torus, 16>},
    {.action = Action::new_cylinder,
     .name = "Cylinder",
     .menu = Menu::new_object,
     .tooltip = "Begins with a new cylinder.",
     .is_enabled = always,
     .perform = new_shape<Kind::cylinder, 12>},

    // --- Files.
    {.action = Action::open,
     .name = "Open…",
     .menu = Menu::file,
     .submenu_before = Menu::new_object,
     .shortcuts = {control('O')},
     .tooltip = "Opens a model in place of the object.",
     .is_enabled = always,
     .perform = perform_on_file<Action::open>},
    {.action = Action::save,
     .name = "Save",
     .menu = Menu::file,
     .begins_group = true,
     .shortcuts = {control('S')},
     .tooltip = "Saves the object to its file, or asks for one.",
     .is_enabled = always,
     .perform = perform_on_file<Action::save>},
    {.action = Action::save_as,
     .name = "Save as…",
     .menu = Menu::file,
     .shortcuts = {control_shift('S')},
     .tooltip = "Saves the object to another file.",
     .is_enabled = always,
     .perform = perform_on_file<Action::save_as>},
    {.action = Action::export_obj,
     .name = "Export OBJ…",
     .menu = Menu::file,
     .shortcuts = {control('E')},
     .tooltip = "Saves the object as an OBJ file.",
     .is_enabled = always,
     .perform = perform_on_file<Action::export_obj>},
    {.action = Action::save_picture,
     .name = "Save a picture…",
     .menu = Menu::file,
     .tooltip = "Saves what the window shows of the object as a PNG picture.",
     .is_enabled = always,
     .perform = perform_on_file<Action::save_picture>},
    {.action = Action::quit,
     .name = "Quit",
     .menu = Menu::file,
     .begins_group = true,
     .shortcuts = {control('Q')},
     .tooltip = "Closes the window, and asks first if changes would be lost.",
     .is_enabled = always,
     .perform = perform_on_file<Action::quit>},

    // --- The object.
    {.action = Action::undo,
     .name = "Undo",
     .menu = Menu::edit,
     .shortcuts = {control('Z')},
     .repeats = true,
     .tooltip = "Takes back the last change of the object.",
     .is_enabled = can_undo,
     .perform = [](Editor& editor) { editor.undo(); }},
    {.action = Action::redo,
     .name = "Redo",
     .menu = Menu::edit,
     .shortcuts = {control_shift('Z'), control('Y')},
     .repeats = true,
     .tooltip = "Does again what was undone last.",
     .is_enabled = can_redo,
     .perform = [](Editor& editor) { editor.execute(command::Redo{}); }},
    {.action = Action::toggle_symmetry,
     .name = "Symmetry",
     .menu = Menu::edit,
     .submenu_before = Menu::undo_memory,
     .begins_group = true,
     .shortcuts = {plain('X')},
     .tooltip = "While this is on, drags act on both sides of a plane at once.",
     .is_enabled = always,
     .is_on = has_symmetry,
     .perform = [](Editor& editor) { editor.set_symmetry(!has_symmetry(editor)); }},
    {.action = Action::remove_pins,
     .name = "Remove all pins",
     .menu = Menu::edit,
     .tooltip = "Removes all pins, so that drags move all of the surface again.",
     .is_enabled = has_pins,
     .perform = [](Editor& editor) { editor.remove_pins(); }},
    {.action = Action::bake,
     .name = "Bake refinement",
     .menu = Menu::edit,
     .begins_group = true,
     .tooltip = "Makes all triangles part of the base mesh, so that none of them is merged again.",
     .is_enabled = is_refined,
     .perform = [](Editor& editor) { editor.execute(command::Bake{}); }},
}};

constexpr std::array<ActionInfo, kActionCount - kFirstViewAction - kViewActionCount> kLaterActions{{
    // --- What the view shows.
    {.action = Action::toggle_wireframe,
     .name = "Wireframe",
     .menu = Menu::view,
     .submenu_before = Menu::navigation,
     .begins_group = true,
     .shortcuts = {plain('W')},
     .tooltip = "Shows the edges of the triangles.",
     .is_enabled = always,
     .is_on = shows<&Display::wireframe>,
     .perform = toggle<&Display::wireframe>},
    {.action = Action::toggle_lattice,
     .name = "Lattice between drags",
     .menu = Menu::view,
     .shortcuts = {plain('L')},
     .tooltip = "Shows the lattice of the next drag, or the cage with control points to drag.",
     .is_enabled = always,
     .is_on = shows<&Display::lattice>,
     .perform = toggle<&Display::lattice>},
    {.action = Action::toggle_levels,
     .name = "Refinement levels",
     .menu = Menu::view,
     .shortcuts = {plain('V')},
     .tooltip = "Colours the surface by how often its triangles were split.",
     .is_enabled = always,
     .is_on = shows<&Display::levels>,
     .perform = toggle<&Display::levels>},
    {.action = Action::toggle_symmetry_plane,
     .name = "Symmetry plane",
     .menu = Menu::view,
     .tooltip = "Shows the plane of symmetry while symmetry is on.",
     .is_enabled = always,
     .is_on = shows<&Display::symmetry_plane>,
     .perform = toggle<&Display::symmetry_plane>},

    // --- Tools.
    {.action = Action::toggle_connected,
     .name = "Connected",
     .menu = Menu::tools,
     .tooltip = "Only the part of the surface that is connected to the grabbed point follows a "
                "drag, and not other parts that are near it.",
     .is_enabled = always,
     .is_on = drags<&DragOptions::connected>,
     .perform = toggle<&DragOptions::connected>},
    {.action = Action::toggle_fold_free,
     .name = "Fold-free",
     .menu = Menu::tools,
     .tooltip = "A drag never turns space inside out, because a long drag is divided into steps "
                "along the cursor's path.",
     .is_enabled = always,
     .is_on = drags<&DragOptions::fold_free>,
     .perform = toggle<&DragOptions::fold_free>},
    {.action = Action::toggle_pinning,
     .name = "Pin",
     .menu = Menu::tools,
     .begins_group = true,
     .tooltip = "While this is on, a click on the surface sets a pin, which drags leave where it "
                "is, and a click on a pin removes it.",
     .is_enabled = always,
     .is_on = [](const Editor& editor) { return editor.sets_pins; },
     .perform = [](Editor& editor) { editor.sets_pins = !editor.sets_pins; }},
    {.action = Action::toggle_pin,
     .name = "Pin under the cursor",
     .menu = Menu::tools,
     .shortcuts = {plain('P')},
     .tooltip = "The key sets a pin where the cursor is on the surface, or removes the one there.",
     .is_enabled = has_cursor,
     .perform = [](Editor& editor) { toggle_pin_at_cursor(editor); }},
    {.action = Action::smaller_radius,
     .name = "Smaller radius",
     .menu = Menu::tools,
     .begins_group = true,
     .shortcuts = {typed('[')},
     .tooltip = "Makes the radius of the brush smaller by one step.",
     .is_enabled = always,
     .perform =
         [](Editor& editor) { editor.set_radius(editor.workspace().radius() / kRadiusStep); }},
    {.action = Action::larger_radius,
     .name = "Larger radius",
     .menu = Menu::tools,
     .shortcuts = {typed(']')},
     .tooltip = "Makes the radius of the brush larger by one step.",
     .is_enabled = always,
     .perform =
         [](Editor& editor) { editor.set_radius(editor.workspace().radius() * kRadiusStep); }},
}};

// The table.
constexpr std::array<ActionInfo, kActionCount> kActions = [] {
    std::array<ActionInfo, kActionCount> all;
    auto end = std::ranges::copy(kEarlierActions, all.begin()).out;
    end = std::ranges::copy(kViewActions, end).out;
    std::ranges::copy(kLaterActions, end);
    return all;
}();

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        if (kActions[i].action != static_cast<Action>(i)) return false;
    }
    return true;
}
static_assert(is_in_order(), "each row stands at the place of its action in the enumeration");

template <typename Matches>
std::optional<Action> find_action(const Matches& matches) {
    for (const ActionInfo& info : kActions) {
        if (std::ranges::any_of(info.shortcuts, matches)) return info.action;
    }
    return std::nullopt;
}

std::string key_name(const Shortcut& shortcut) {
    if (shortcut.character != 0) return std::string(1, shortcut.character);
    switch (shortcut.key) {
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
        default:
            return std::string(1, static_cast<char>(shortcut.key));
    }
}

}  // namespace

std::span<const ActionInfo, kActionCount> all_actions() { return kActions; }

const ActionInfo& info_of(Action action) { return kActions[static_cast<std::size_t>(action)]; }

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

std::string tooltip_with_shortcuts(Action action) {
    const ActionInfo& info = info_of(action);
    std::string labels;
    for (const Shortcut& shortcut : info.shortcuts) {
        if (shortcut.exists()) labels += (labels.empty() ? "" : ", ") + label_of(shortcut);
    }
    return info.tooltip + (labels.empty() ? "" : " (" + labels + ")");
}

}  // namespace pectin

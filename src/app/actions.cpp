#include "app/actions.h"

#include "app/action_rows.h"
#include "app/editor.h"
#include "app/help_actions.h"
#include "app/tool_actions.h"
#include "app/view_actions.h"

namespace pectin {
namespace {

using action_rows::always;
using action_rows::control;
using action_rows::control_shift;
using action_rows::plain;
using action_rows::typed;
using Kind = command::Shape::Kind;

// --- When an action is enabled. During work in the background only settings of the session may be
// read, and the figures of the workspace.

// If the limit of the history has dropped steps, undo says so.
bool can_undo(const Editor& editor) {
    const ObjectFigures object = editor.workspace().object_figures();
    return object.undo_steps > 0 || object.lost_undo_steps > 0;
}

bool can_redo(const Editor& editor) { return editor.workspace().object_figures().redo_steps > 0; }
bool is_refined(const Editor& editor) { return editor.workspace().object_figures().is_refined; }
bool has_pins(const Editor& editor) { return !editor.pins().is_empty(); }
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

void set_scale(Editor& editor, double scale) { editor.preferences.scale = scale; }

void toggle_panels(Editor& editor) {
    editor.preferences.hides_panels = !editor.preferences.hides_panels;
}

void toggle_theme(Editor& editor) {
    Theme& theme = editor.preferences.theme;
    theme = theme == Theme::light ? Theme::dark : Theme::light;
}

template <bool Display::*kSetting>
bool shows(const Editor& editor) {
    return editor.display.*kSetting;
}

template <bool Display::*kSetting>
void toggle(Editor& editor) {
    editor.display.*kSetting = !(editor.display.*kSetting);
}

// Actions before those that move the view, and between them and the tools.
constexpr std::array<ActionInfo, kFirstViewAction> kEarlierActions{{
    // --- New objects.
    {.action = Action::new_sphere,
     .name = "Sphere",
     .menu = Menu::new_object,
     .tooltip = "Begin with a new sphere.",
     .is_enabled = always,
     .perform = new_shape<Kind::sphere, 4>},
    {.action = Action::new_cube,
     .name = "Cube",
     .menu = Menu::new_object,
     .tooltip = "Begin with a new cube.",
     .is_enabled = always,
     .perform = new_shape<Kind::cube, 16>},
    {.action = Action::new_plane,
     .name = "Plane",
     .menu = Menu::new_object,
     .tooltip = "Begin with a new square plane.",
     .is_enabled = always,
     .perform = new_shape<Kind::plane, 32>},
    {.action = Action::new_torus,
     .name = "Torus",
     .menu = Menu::new_object,
     .tooltip = "Begin with a new torus.",
     .is_enabled = always,
     .perform = new_shape<Kind::torus, 16>},
    {.action = Action::new_cylinder,
     .name = "Cylinder",
     .menu = Menu::new_object,
     .tooltip = "Begin with a new cylinder.",
     .is_enabled = always,
     .perform = new_shape<Kind::cylinder, 12>},

    // --- Files.
    {.action = Action::open,
     .name = "Open…",
     .menu = Menu::file,
     .submenu_before = Menu::new_object,
     .shortcuts = {control('O')},
     .tooltip = "Open a model in place of the object.",
     .is_enabled = always,
     .perform = perform_on_file<Action::open>},
    {.action = Action::save,
     .name = "Save",
     .menu = Menu::file,
     .begins_group = true,
     .shortcuts = {control('S')},
     .tooltip = "Save the object to its file, or choose a file for it.",
     .is_enabled = always,
     .perform = perform_on_file<Action::save>},
    {.action = Action::save_as,
     .name = "Save as…",
     .menu = Menu::file,
     .shortcuts = {control_shift('S')},
     .tooltip = "Save the object to another OBJ file, and go on with that one.",
     .is_enabled = always,
     .perform = perform_on_file<Action::save_as>},
    {.action = Action::save_picture,
     .name = "Save a picture…",
     .menu = Menu::file,
     .tooltip = "Save the present view of the object as a PNG picture.",
     .is_enabled = always,
     .perform = perform_on_file<Action::save_picture>},
    {.action = Action::quit,
     .name = "Quit",
     .menu = Menu::file,
     .begins_group = true,
     .shortcuts = {control('Q')},
     .tooltip = "Close the window, after a question if changes would be lost.",
     .is_enabled = always,
     .perform = perform_on_file<Action::quit>},

    // --- The object.
    {.action = Action::undo,
     .name = "Undo",
     .menu = Menu::edit,
     .shortcuts = {control('Z')},
     .repeats = true,
     .tooltip = "Take back the last change of the object.",
     .is_enabled = can_undo,
     .needs = "There is nothing to undo.",
     .perform = [](Editor& editor) { editor.undo(); }},
    {.action = Action::redo,
     .name = "Redo",
     .menu = Menu::edit,
     .shortcuts = {control_shift('Z'), control('Y')},
     .repeats = true,
     .tooltip = "Do again what was undone last.",
     .is_enabled = can_redo,
     .needs = "There is nothing to redo.",
     .perform = [](Editor& editor) { editor.execute(command::Redo{}); }},
    {.action = Action::toggle_symmetry,
     .name = "Symmetry",
     .menu = Menu::edit,
     .submenu_before = Menu::undo_memory,
     .begins_group = true,
     .shortcuts = {plain('X')},
     .tooltip = "Mirror every drag across a plane.",
     .is_enabled = always,
     .is_on = has_symmetry,
     .perform = [](Editor& editor) { editor.set_symmetry(!has_symmetry(editor)); }},
    {.action = Action::remove_pins,
     .name = "Remove all pins",
     .menu = Menu::edit,
     .tooltip = "Remove all pins, so that drags move the whole surface again.",
     .is_enabled = has_pins,
     .needs = "There are no pins.",
     .perform = [](Editor& editor) { editor.remove_pins(); }},
    {.action = Action::readapt,
     .name = "Apply detail to the whole object",
     .menu = Menu::edit,
     .begins_group = true,
     .tooltip = "Split and merge triangles by the present detail wherever drags have moved the "
                "surface.",
     .is_enabled = always,
     .perform = [](Editor& editor) { editor.execute(command::Readapt{}); }},
    {.action = Action::bake,
     .name = "Keep the triangles",
     .menu = Menu::edit,
     .tooltip = "Keep the present triangles for good: none of them is merged again.",
     .is_enabled = is_refined,
     .needs = "Nothing is refined.",
     .perform = [](Editor& editor) { editor.execute(command::Bake{}); }},
}};

constexpr std::array<ActionInfo, kFirstToolAction - kFirstViewAction - kViewActionCount>
    kDisplayActions{{
        // --- What the view shows.
        {.action = Action::toggle_wireframe,
         .name = "Wireframe",
         .menu = Menu::view,
         .submenu_before = Menu::navigation,
         .begins_group = true,
         .shortcuts = {plain('W')},
         .tooltip = "Show the edges of the triangles.",
         .is_enabled = always,
         .is_on = shows<&Display::wireframe>,
         .perform = toggle<&Display::wireframe>},
        {.action = Action::toggle_lattice,
         .name = "Lattice",
         .menu = Menu::view,
         .shortcuts = {plain('L')},
         .tooltip = "Show the lattice: that of the next drag, or the cage, whose points can then "
                    "be dragged.",
         .is_enabled = always,
         .is_on = shows<&Display::lattice>,
         .perform = toggle<&Display::lattice>},
        {.action = Action::toggle_levels,
         .name = "Refinement levels",
         .menu = Menu::view,
         .shortcuts = {plain('V')},
         .tooltip = "Colour the surface by how often its triangles were split.",
         .is_enabled = always,
         .is_on = shows<&Display::levels>,
         .perform = toggle<&Display::levels>},
        {.action = Action::toggle_drag_lattice,
         .name = "Lattice during drags",
         .menu = Menu::view,
         .tooltip = "Show the lattice that deforms the object during a drag.",
         .is_enabled = always,
         .is_on = shows<&Display::drag_lattice>,
         .perform = toggle<&Display::drag_lattice>},
        {.action = Action::toggle_symmetry_plane,
         .name = "Symmetry plane",
         .menu = Menu::view,
         .tooltip = "Show the plane of symmetry while symmetry is on.",
         .is_enabled = always,
         .is_on = shows<&Display::symmetry_plane>,
         .perform = toggle<&Display::symmetry_plane>},

        {.action = Action::toggle_panels,
         .name = "Panels",
         .menu = Menu::view,
         .begins_group = true,
         .shortcuts = {plain(Key::tab)},
         .tooltip = "Show the tools on the left and the settings on the right.",
         .is_enabled = always,
         .is_on = [](const Editor& editor) { return !editor.preferences.hides_panels; },
         .perform = toggle_panels},
        {.action = Action::toggle_light_theme,
         .name = "Light theme",
         .menu = Menu::view,
         .tooltip = "Dark text on light panels, for bright surroundings.",
         .is_enabled = always,
         .is_on = [](const Editor& editor) { return editor.preferences.theme == Theme::light; },
         .perform = toggle_theme},
        {.action = Action::larger_text,
         .name = "Larger text",
         .menu = Menu::view,
         .shortcuts = {control('+'), control('='), control_shift('=')},
         .repeats = true,
         .tooltip = "Make text and controls larger.",
         .is_enabled =
             [](const Editor& editor) { return editor.preferences.scale < kMostTextScale; },
         .needs = "Text and controls have their largest size.",
         .perform =
             [](Editor& editor) { set_scale(editor, larger_scale(editor.preferences.scale)); }},
        {.action = Action::smaller_text,
         .name = "Smaller text",
         .menu = Menu::view,
         .shortcuts = {control('-')},
         .repeats = true,
         .tooltip = "Make text and controls smaller.",
         .is_enabled =
             [](const Editor& editor) { return editor.preferences.scale > kLeastTextScale; },
         .needs = "Text and controls have their smallest size.",
         .perform =
             [](Editor& editor) { set_scale(editor, smaller_scale(editor.preferences.scale)); }},
        {.action = Action::normal_text,
         .name = "Text of normal size",
         .menu = Menu::view,
         .shortcuts = {control('0')},
         .tooltip = "Give text and controls the size that fits the screen.",
         .is_enabled = [](const Editor& editor) { return editor.preferences.scale != 1.0; },
         .needs = "Text and controls have their normal size.",
         .perform = [](Editor& editor) { set_scale(editor, 1.0); }},
        {.action = Action::open_menus,
         .name = "Menus by keyboard",
         .menu = Menu::view,
         .shortcuts = {plain(Key::f10)},
         .tooltip = "Go to the menus, where the arrow keys move, Enter chooses and Esc closes.",
         .is_enabled = always,
         .perform = [](Editor& editor) { editor.menus_requested = true; }},
    }};

// The table.
constexpr std::array<ActionInfo, kActionCount> kActions = [] {
    std::array<ActionInfo, kActionCount> all;
    auto end = std::ranges::copy(kEarlierActions, all.begin()).out;
    end = std::ranges::copy(kViewActions, end).out;
    end = std::ranges::copy(kDisplayActions, end).out;
    end = std::ranges::copy(kToolActions, end).out;
    std::ranges::copy(kHelpActions, end);
    return all;
}();

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        if (kActions[i].action != static_cast<Action>(i)) return false;
    }
    return true;
}
static_assert(is_in_order(), "each row stands at the place of its action in the enumeration");

}  // namespace

std::span<const ActionInfo, kActionCount> all_actions() { return kActions; }

const ActionInfo& info_of(Action action) { return kActions[static_cast<std::size_t>(action)]; }

}  // namespace pectin

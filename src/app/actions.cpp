#include "app/actions.h"

#include "app/editor.h"
#include "app/tools/pin_tool.h"

namespace pectin {
namespace {

using Kind = command::Shape::Kind;

// The brackets change the brush's radius by this factor.
constexpr double kRadiusStep = 1.12;

constexpr Shortcut plain(char letter) { return {.key = Key{letter}}; }
constexpr Shortcut plain(Key key) { return {.key = key}; }
constexpr Shortcut control(char letter) {
    return {.key = Key{letter}, .modifiers = {.control = true}};
}
constexpr Shortcut shift(char letter) { return {.key = Key{letter}, .modifiers = {.shift = true}}; }
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
bool has_cage(const Editor& editor) { return editor.session().lattice_settings().cage.has_value(); }
bool has_brush(const Editor& editor) { return !has_cage(editor); }

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

template <bool DragOptions::*kOption>
bool drags(const Editor& editor) {
    return editor.drag_options.*kOption;
}

template <bool DragOptions::*kOption>
void toggle(Editor& editor) {
    editor.drag_options.*kOption = !(editor.drag_options.*kOption);
}

constexpr std::array<ActionInfo, kActionCount> kActions{{
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
     .perform = [](Editor& editor) { editor.undo(); }},
    {.action = Action::redo,
     .name = "Redo",
     .menu = Menu::edit,
     .shortcuts = {control_shift('Z'), control('Y')},
     .repeats = true,
     .tooltip = "Do again what was undone last.",
     .is_enabled = can_redo,
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
     .perform = [](Editor& editor) { editor.execute(command::Bake{}); }},

    // --- The view.
    {.action = Action::frame_all,
     .name = "Frame all",
     .menu = Menu::view,
     .shortcuts = {plain(Key::home), typed('.')},
     .tooltip = "Show the whole object from the present direction.",
     .is_enabled = always,
     .perform = [](Editor& editor) { editor.frame_all(); }},
    {.action = Action::view_front,
     .name = "Front",
     .menu = Menu::view,
     .shortcuts = {plain(Key::keypad_1)},
     .tooltip = "Show the whole object from the front.",
     .is_enabled = always,
     .perform = [](Editor& editor) { editor.frame_all(kFrontView); }},
    {.action = Action::view_right,
     .name = "Right",
     .menu = Menu::view,
     .shortcuts = {plain(Key::keypad_3)},
     .tooltip = "Show the whole object from the right.",
     .is_enabled = always,
     .perform = [](Editor& editor) { editor.frame_all(kRightView); }},
    {.action = Action::view_top,
     .name = "Top",
     .menu = Menu::view,
     .shortcuts = {plain(Key::keypad_7)},
     .tooltip = "Show the whole object from above.",
     .is_enabled = always,
     .perform = [](Editor& editor) { editor.frame_all(kTopView); }},
    {.action = Action::toggle_wireframe,
     .name = "Wireframe",
     .menu = Menu::view,
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
     .tooltip =
         "Show the lattice: that of the next drag, or the cage, whose points can then be dragged.",
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
     .is_enabled = [](const Editor& editor) { return editor.preferences.scale < kMostTextScale; },
     .perform = [](Editor& editor) { set_scale(editor, larger_scale(editor.preferences.scale)); }},
    {.action = Action::smaller_text,
     .name = "Smaller text",
     .menu = Menu::view,
     .shortcuts = {control('-')},
     .repeats = true,
     .tooltip = "Make text and controls smaller.",
     .is_enabled = [](const Editor& editor) { return editor.preferences.scale > kLeastTextScale; },
     .perform = [](Editor& editor) { set_scale(editor, smaller_scale(editor.preferences.scale)); }},
    {.action = Action::normal_text,
     .name = "Text of normal size",
     .menu = Menu::view,
     .shortcuts = {control('0')},
     .tooltip = "Give text and controls the size that fits the screen.",
     .is_enabled = [](const Editor& editor) { return editor.preferences.scale != 1.0; },
     .perform = [](Editor& editor) { set_scale(editor, 1.0); }},
    {.action = Action::open_menus,
     .name = "Menus by keyboard",
     .menu = Menu::view,
     .shortcuts = {plain(Key::f10)},
     .tooltip = "Go to the menus, where the arrow keys move, Enter chooses and Esc closes.",
     .is_enabled = always,
     .perform = [](Editor& editor) { editor.menus_requested = true; }},

    // --- Tools.
    {.action = Action::use_brush,
     .name = "Sculpt",
     .menu = Menu::tools,
     .shortcuts = {plain('S')},
     .tooltip = "Drag the surface to pull it; the area around it follows.",
     .is_enabled = always,
     .is_on = [](const Editor& editor) { return has_brush(editor) && !editor.sets_pins; },
     .perform = [](Editor& editor) { editor.use_brush(); }},
    {.action = Action::use_cage,
     .name = "Cage",
     .menu = Menu::tools,
     .shortcuts = {plain('C')},
     .tooltip = "Deform the object with the control points of a box around it.",
     .is_enabled = always,
     .is_on = [](const Editor& editor) { return has_cage(editor) && !editor.sets_pins; },
     .perform = [](Editor& editor) { editor.use_cage(); }},
    {.action = Action::toggle_pinning,
     .name = "Pin",
     .menu = Menu::tools,
     .shortcuts = {shift('P')},
     .tooltip =
         "Click the surface to set pins, which drags leave where they are, and click a pin to "
         "remove it.",
     .is_enabled = always,
     .is_on = [](const Editor& editor) { return editor.sets_pins; },
     .perform = [](Editor& editor) { editor.sets_pins = !editor.sets_pins; }},
    {.action = Action::toggle_pin,
     .name = "Pin under the cursor",
     .menu = Menu::tools,
     .shortcuts = {plain('P')},
     .tooltip = "Set a pin under the cursor, or remove the one that is there.",
     .is_enabled = has_cursor,
     .perform = [](Editor& editor) { toggle_pin_at_cursor(editor); }},
    {.action = Action::fit_cage,
     .name = "Fit the cage to the object",
     .menu = Menu::tools,
     .tooltip = "Put the cage around the object as it is now.",
     .is_enabled = has_cage,
     .perform = [](Editor& editor) { editor.fit_cage(); }},
    {.action = Action::toggle_connected,
     .name = "Connected",
     .menu = Menu::tools,
     .begins_group = true,
     .tooltip = "Move only the surface connected to the point you grab, not parts that are merely "
                "close.",
     .is_enabled = always,
     .is_on = drags<&DragOptions::connected>,
     .perform = toggle<&DragOptions::connected>},
    {.action = Action::toggle_fold_free,
     .name = "Fold-free",
     .menu = Menu::tools,
     .tooltip = "Prevents self-intersections: long drags are split into steps along the cursor's "
                "path.",
     .is_enabled = always,
     .is_on = drags<&DragOptions::fold_free>,
     .perform = toggle<&DragOptions::fold_free>},
    {.action = Action::smaller_radius,
     .name = "Smaller radius",
     .menu = Menu::tools,
     .begins_group = true,
     .shortcuts = {typed('[')},
     .tooltip = "Make the radius of the brush smaller by one step.",
     .is_enabled = has_brush,
     .perform =
         [](Editor& editor) { editor.set_radius(editor.workspace().radius() / kRadiusStep); }},
    {.action = Action::larger_radius,
     .name = "Larger radius",
     .menu = Menu::tools,
     .shortcuts = {typed(']')},
     .tooltip = "Make the radius of the brush larger by one step.",
     .is_enabled = has_brush,
     .perform =
         [](Editor& editor) { editor.set_radius(editor.workspace().radius() * kRadiusStep); }},
}};

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

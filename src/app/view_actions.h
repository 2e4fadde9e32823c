// The rows of the table of actions (actions.cpp) that move the view.
#pragma once

#include <array>
#include <cstddef>

#include "app/action_rows.h"
#include "app/actions.h"
#include "app/editor.h"

namespace pectin {

// Degrees of one step around the object, and notches of one step towards it.
inline constexpr double kTurnStep = 15.0, kZoomStep = 2.0;

namespace view_actions {

inline void frame_all(Editor& editor) { editor.view_control().frame_all(); }

template <const Vec3& kDirection>
void look_from(Editor& editor) {
    editor.view_control().look_from(kDirection);
}

template <int kToRight, int kUpwards>
void turn(Editor& editor) {
    editor.view_control().turn(kToRight * kTurnStep, kUpwards * kTurnStep);
}

template <int kSteps>
void zoom(Editor& editor) {
    editor.view_control().zoom(kSteps * kZoomStep);
}

inline bool is_orthographic(const Editor& editor) { return editor.camera().is_orthographic(); }
inline void toggle_orthographic(Editor& editor) {
    editor.view_control().set_projection(is_orthographic(editor) ? Projection::perspective
                                                                 : Projection::orthographic);
}

inline bool is_z_up(const Editor& editor) { return editor.view_control().up_axis() == UpAxis::z; }
inline void toggle_z_up(Editor& editor) {
    editor.view_control().set_up_axis(is_z_up(editor) ? UpAxis::y : UpAxis::z);
}

template <MousePreset kPreset>
bool navigates_as(const Editor& editor) {
    return editor.preferences.mouse == kPreset;
}
template <MousePreset kPreset>
void navigate_as(Editor& editor) {
    editor.preferences.mouse = kPreset;
}

}  // namespace view_actions

// From frame_all to the action before toggle_wireframe.
inline constexpr std::size_t kFirstViewAction = static_cast<std::size_t>(Action::frame_all);
inline constexpr std::size_t kViewActionCount =
    static_cast<std::size_t>(Action::toggle_wireframe) - kFirstViewAction;
inline constexpr std::array<ActionInfo, kViewActionCount> kViewActions{{
    {.action = Action::frame_all,
     .name = "Frame all",
     .menu = Menu::view,
     .shortcuts = {action_rows::plain(Key::home), action_rows::typed('.')},
     .tooltip = "Show the whole object from the present direction.",
     .is_enabled = action_rows::always,
     .perform = view_actions::frame_all},

    // --- Viewpoints.
    {.action = Action::view_front,
     .name = "Front",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::plain(Key::keypad_1)},
     .tooltip = "Look at the object from the front.",
     .is_enabled = action_rows::always,
     .perform = view_actions::look_from<kFrontView>},
    {.action = Action::view_back,
     .name = "Back",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::control(Key::keypad_1)},
     .tooltip = "Look at the object from behind.",
     .is_enabled = action_rows::always,
     .perform = view_actions::look_from<kBackView>},
    {.action = Action::view_right,
     .name = "Right",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::plain(Key::keypad_3)},
     .tooltip = "Look at the object from the right.",
     .is_enabled = action_rows::always,
     .perform = view_actions::look_from<kRightView>},
    {.action = Action::view_left,
     .name = "Left",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::control(Key::keypad_3)},
     .tooltip = "Look at the object from the left.",
     .is_enabled = action_rows::always,
     .perform = view_actions::look_from<kLeftView>},
    {.action = Action::view_top,
     .name = "Top",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::plain(Key::keypad_7)},
     .tooltip = "Look at the object from above.",
     .is_enabled = action_rows::always,
     .perform = view_actions::look_from<kTopView>},
    {.action = Action::view_bottom,
     .name = "Bottom",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::control(Key::keypad_7)},
     .tooltip = "Look at the object from below.",
     .is_enabled = action_rows::always,
     .perform = view_actions::look_from<kBottomView>},
    {.action = Action::turn_left,
     .name = "Turn to the left",
     .menu = Menu::viewpoint,
     .begins_group = true,
     .shortcuts = {action_rows::plain(Key::keypad_4)},
     .repeats = true,
     .tooltip = "Move the viewpoint by 15 degrees to the left around the object.",
     .is_enabled = action_rows::always,
     .perform = view_actions::turn<-1, 0>},
    {.action = Action::turn_right,
     .name = "Turn to the right",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::plain(Key::keypad_6)},
     .repeats = true,
     .tooltip = "Move the viewpoint by 15 degrees to the right around the object.",
     .is_enabled = action_rows::always,
     .perform = view_actions::turn<1, 0>},
    {.action = Action::turn_up,
     .name = "Turn upwards",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::plain(Key::keypad_8)},
     .repeats = true,
     .tooltip = "Move the viewpoint upwards by 15 degrees around the object.",
     .is_enabled = action_rows::always,
     .perform = view_actions::turn<0, 1>},
    {.action = Action::turn_down,
     .name = "Turn downwards",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::plain(Key::keypad_2)},
     .repeats = true,
     .tooltip = "Move the viewpoint downwards by 15 degrees around the object.",
     .is_enabled = action_rows::always,
     .perform = view_actions::turn<0, -1>},
    {.action = Action::zoom_in,
     .name = "Zoom in",
     .menu = Menu::viewpoint,
     .begins_group = true,
     .shortcuts = {action_rows::plain(Key::keypad_add)},
     .repeats = true,
     .tooltip = "Move the viewpoint towards the middle of the picture, but never through the "
                "surface.",
     .is_enabled = action_rows::always,
     .perform = view_actions::zoom<1>},
    {.action = Action::zoom_out,
     .name = "Zoom out",
     .menu = Menu::viewpoint,
     .shortcuts = {action_rows::plain(Key::keypad_subtract)},
     .repeats = true,
     .tooltip = "Move the viewpoint away from the middle of the picture.",
     .is_enabled = action_rows::always,
     .perform = view_actions::zoom<-1>},

    // --- How the view behaves.
    {.action = Action::toggle_orthographic,
     .name = "Orthographic",
     .menu = Menu::view,
     .submenu_before = Menu::viewpoint,
     .begins_group = true,
     .shortcuts = {action_rows::plain(Key::keypad_5)},
     .tooltip = "Show the object without perspective, so that near and far parts have the same "
                "scale.",
     .is_enabled = action_rows::always,
     .is_on = view_actions::is_orthographic,
     .perform = view_actions::toggle_orthographic},
    {.action = Action::toggle_z_up,
     .name = "Z is up",
     .menu = Menu::view,
     .tooltip = "Show models upright whose z axis points upwards instead of their y axis.",
     .is_enabled = action_rows::always,
     .is_on = view_actions::is_z_up,
     .perform = view_actions::toggle_z_up},
    {.action = Action::navigate_as_blender,
     .name = "As in Blender",
     .menu = Menu::navigation,
     .tooltip = "The middle button rotates the view, with Shift it pans, and with Ctrl it zooms.",
     .is_enabled = action_rows::always,
     .is_on = view_actions::navigates_as<MousePreset::blender>,
     .is_choice = true,
     .perform = view_actions::navigate_as<MousePreset::blender>},
    {.action = Action::navigate_as_maya,
     .name = "As in Maya",
     .menu = Menu::navigation,
     .tooltip = "With Alt the left button rotates the view, the middle one pans, and the right one "
                "zooms.",
     .is_enabled = action_rows::always,
     .is_on = view_actions::navigates_as<MousePreset::maya>,
     .is_choice = true,
     .perform = view_actions::navigate_as<MousePreset::maya>},
    {.action = Action::navigate_as_zbrush,
     .name = "As in ZBrush",
     .menu = Menu::navigation,
     .tooltip = "Beside the object the left button rotates the view, with Alt it pans, and when "
                "Alt is released it zooms.",
     .is_enabled = action_rows::always,
     .is_on = view_actions::navigates_as<MousePreset::zbrush>,
     .is_choice = true,
     .perform = view_actions::navigate_as<MousePreset::zbrush>},
}};

}  // namespace pectin

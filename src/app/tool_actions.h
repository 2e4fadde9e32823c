// The rows of the table of actions (actions.cpp) that choose tools and set what drags do.
#pragma once

#include <array>
#include <cstddef>

#include "app/action_rows.h"
#include "app/actions.h"
#include "app/editor.h"
#include "app/tools/pin_tool.h"
#include "app/tools/repeat_drag.h"

namespace pectin {

namespace tool_actions {

using action_rows::always;
using action_rows::plain;
using action_rows::shift;
using action_rows::typed;

// The brackets change the brush's radius by this factor.
constexpr double kRadiusStep = 1.12;

inline bool has_cage(const Editor& editor) { return editor.has_cage(); }
inline bool has_brush(const Editor& editor) { return !editor.has_cage(); }
inline bool can_repeat(const Editor& editor) {
    return editor.last_drag && has_brush(editor) && editor.pointer().is_in_viewport;
}
inline bool has_cursor(const Editor& editor) { return editor.pointer().is_in_viewport; }

template <bool DragOptions::*kOption>
bool drags(const Editor& editor) {
    return editor.drag_options.*kOption;
}

template <bool DragOptions::*kOption>
void toggle(Editor& editor) {
    editor.drag_options.*kOption = !(editor.drag_options.*kOption);
}

constexpr const char* kNoBrush = "The radius cannot be changed while a cage is in use.";
constexpr const char* kNeedsSurface = "Put the cursor on the surface and press the key.";

inline void say_that_surface_is_needed(Editor& editor) {
    editor.workspace().set_message(kNeedsSurface, Messages::Kind::information);
}

inline void toggle_pin(Editor& editor) {
    if (!toggle_pin_at_cursor(editor)) say_that_surface_is_needed(editor);
}

inline void repeat_drag(Editor& editor) {
    const auto drag = repeated_drag(editor);
    if (!drag) return say_that_surface_is_needed(editor);
    editor.execute(*drag);
}

// From use_brush to the action before show_inputs.
inline constexpr std::size_t kFirstToolAction = static_cast<std::size_t>(Action::use_brush);
inline constexpr std::size_t kToolActionCount =
    static_cast<std::size_t>(Action::show_inputs) - kFirstToolAction;
inline constexpr std::array<ActionInfo, kToolActionCount> kToolActions{{
    {.action = Action::use_brush,
     .name = "Sculpt",
     .menu = Menu::tools,
     .shortcuts = {plain('S')},
     .tooltip = "Drag the surface to pull it; the area around it follows.",
     .is_enabled = always,
     .is_on = [](const Editor& editor) { return has_brush(editor) && !editor.sets_pins; },
     .is_choice = true,
     .perform = [](Editor& editor) { editor.use_brush(); }},
    {.action = Action::use_cage,
     .name = "Cage",
     .menu = Menu::tools,
     .shortcuts = {plain('C')},
     .tooltip = "Deform the object with the control points of a box around it.",
     .is_enabled = always,
     .is_on = [](const Editor& editor) { return has_cage(editor) && !editor.sets_pins; },
     .is_choice = true,
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
     .needs = kNeedsSurface,
     .perform = toggle_pin},
    {.action = Action::fit_cage,
     .name = "Fit the cage to the object",
     .menu = Menu::tools,
     .tooltip = "Put the cage around the object as it is now.",
     .is_enabled = has_cage,
     .needs = "There is no cage.",
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
    {.action = Action::repeat_drag,
     .name = "Repeat last drag",
     .menu = Menu::tools,
     .begins_group = true,
     .shortcuts = {shift('R')},
     .tooltip =
         "Repeat the last drag at the point under the cursor, turned as the surface there is "
         "turned, so that what was pulled outwards is pulled outwards again.",
     .is_enabled = can_repeat,
     .needs = "Drag with Sculpt first. Then put the cursor on the surface and press the key.",
     .perform = repeat_drag},
    {.action = Action::smaller_radius,
     .name = "Smaller radius",
     .menu = Menu::tools,
     .begins_group = true,
     .shortcuts = {typed('[')},
     .tooltip = "Make the radius of the brush smaller by one step.",
     .is_enabled = has_brush,
     .needs = kNoBrush,
     .perform =
         [](Editor& editor) { editor.set_radius_value(editor.radius_value() / kRadiusStep); }},
    {.action = Action::larger_radius,
     .name = "Larger radius",
     .menu = Menu::tools,
     .shortcuts = {typed(']')},
     .tooltip = "Make the radius of the brush larger by one step.",
     .is_enabled = has_brush,
     .needs = kNoBrush,
     .perform =
         [](Editor& editor) { editor.set_radius_value(editor.radius_value() * kRadiusStep); }},
}};

}  // namespace tool_actions

using tool_actions::kFirstToolAction;
using tool_actions::kToolActions;

}  // namespace pectin

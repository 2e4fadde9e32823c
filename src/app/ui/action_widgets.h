// Buttons, checkboxes and tooltips for the actions of the table (actions.h), so that panels and
// menus show the same names and tooltips.
//
// Precondition of all functions: a window of Dear ImGui is being laid out.
#pragma once

#include "app/actions.h"
#include "app/editor.h"

namespace pectin {

// Shows a text, wrapped at a readable width, while the cursor is over the last item.
void tooltip(const char* text);
// The same with the tooltip of an action and its shortcuts.
void tooltip_of(Action action);

// Draws a button that is highlighted while it is on. Returns whether it was pressed.
bool toggle_button(const char* label, bool is_on, float width);

// A button and a checkbox that switch something on and off. label: instead of the action's name.
// Precondition: the action has is_on().
void action_button(Editor& editor, Action action, float width, const char* label = nullptr);
void action_checkbox(Editor& editor, Action action);

}  // namespace pectin

// Buttons, checkboxes and tooltips for the actions of the table (actions.h), so that panels and
// menus show the same names and tooltips.
//
// Precondition of all functions: a window of Dear ImGui is being laid out.
#pragma once

#include <imgui.h>

#include "app/actions.h"
#include "app/editor.h"
#include "app/ui/icons.h"

namespace pectin {

// Shows a text, wrapped at a readable width, while the cursor is over the last item, also if it is
// disabled, and adds the item to the list of controls (controls.h). Every control of the panels has
// a tooltip. name: of the control in that list.
void tooltip(const char* name, const char* text);
// The same with the name and the tooltip of an action and its shortcuts.
void tooltip_of(Action action);

// Draws a button that is highlighted while it is on. Returns whether it was pressed.
bool toggle_button(const char* label, bool is_on, float width);

// Buttons and a checkbox that perform an action. Those with is_on() are highlighted or checked
// while it is on. All are disabled while the action is not enabled. width: 0 for that of the label,
// below 0 for the rest of the row.
void action_button(Editor& editor, Action action, float width);
void action_checkbox(Editor& editor, Action action);
// A square button with an icon. Its tooltip has the name and the keys in a line of their own and
// stands to its right.
void icon_button(Editor& editor, Action action, Icon icon, float size);

}  // namespace pectin

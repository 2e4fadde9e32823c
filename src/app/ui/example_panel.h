// The panel of an example that is open: the caption of its step and buttons to go on.
#pragma once

#include "app/editor.h"

namespace pectin {

// Begins the panel's window above the height `bottom`. If it returns true, draw_example_panel() and
// ImGui::End() must follow. scale: of the screen.
bool begin_example_panel(const Editor& editor, float bottom, float scale);
void draw_example_panel(ExamplePlayer& example);

}  // namespace pectin

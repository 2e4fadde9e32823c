// The panel of an example that is open: the caption of its step and buttons to go on.
#pragma once

#include <imgui.h>

#include "app/editor.h"

namespace pectin {

// Begins the panel's window at the bottom of the area from `min` to `max`, as high as the longest
// caption of the example needs, so that it stays as it is from step to step. If it returns true,
// draw_example_panel() and ImGui::End() must follow. scale: of the screen.
bool begin_example_panel(const Editor& editor, const ImVec2& min, const ImVec2& max, float scale);
void draw_example_panel(ExamplePlayer& example);

}  // namespace pectin

// The strip of icons on the left: tools and switches.
#pragma once

#include "app/editor.h"

namespace pectin {

// The size of a button of the strip, in pixels, if this height is available for all of them. They
// become smaller in a low window. scale: of the screen and the user together.
float tool_button_size(float available, float scale);

// Draws the strip into the present window of Dear ImGui. size: as returned by tool_button_size().
void draw_tool_strip(Editor& editor, float size);

}  // namespace pectin

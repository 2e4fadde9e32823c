// The settings of the brush: radius, falloff and what a drag does.
#pragma once

#include "app/editor.h"

namespace pectin {

// Lays them out in this width, in pixels; they are disabled while drags use a cage. scale: of the
// user interface. Precondition: a window of Dear ImGui is being laid out.
void draw_brush_section(Editor& editor, float width, float scale);

}  // namespace pectin

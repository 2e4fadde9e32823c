// Draws the axes in the corner of the viewport (app/axes_gizmo.h).
#pragma once

#include "app/editor.h"

namespace pectin {

// To be called within a frame of Dear ImGui. The axes are drawn behind all panels.
void draw_axes(const Editor& editor, float scale);

}  // namespace pectin

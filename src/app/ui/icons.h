// Icons of tools and actions, drawn as lines and shapes, so that they are sharp at every scale.
#pragma once

#include <imgui.h>

namespace pectin {

enum class Icon {
    sculpt,
    cage,
    pin,
    symmetry,
    connected,
    fold_free,
    wireframe,
    levels,
    frame_all,
    undo,
    redo,
    help
};

// Draws the icon into the square with this centre. size: length of its side, in pixels.
void draw_icon(ImDrawList& list, Icon icon, const ImVec2& centre, float size, ImU32 colour);

}  // namespace pectin

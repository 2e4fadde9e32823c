// Colours, sizes and font of the panels.
#pragma once

namespace pectin {

// Sets the style and font of the current Dear ImGui context. scale: of the screen, 1 on an ordinary
// one. To be called once, before the texture of the fonts is made.
void apply_theme(float scale);

}  // namespace pectin

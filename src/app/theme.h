// How panels look: dark, calm, and as large as the screen asks for.
#pragma once

namespace pectin {

// Style and font of the current Dear ImGui context. scale: 1 on an ordinary screen. Call once,
// before the fonts' texture is made.
void apply_theme(float scale);

}  // namespace pectin

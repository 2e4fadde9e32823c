// The background of the light theme, also for pictures.
#pragma once

#include "render/renderer.h"

namespace pectin {

// Gives the scene a light background, and darkens its overlay, whose colours are meant for a dark
// one, so that it stays visible. Hues stay as they are. Cost: O(overlay).
void use_light_background(Scene& scene);

}  // namespace pectin

// The scene that shows an Editor's object and overlays.
#pragma once

#include "app/editor.h"
#include "render/renderer.h"

namespace pectin {

// pixel_scale: pixels per unit of window coordinates, times the screen's content scale.
Scene editor_scene(const Editor& editor, float pixel_scale);

}  // namespace pectin

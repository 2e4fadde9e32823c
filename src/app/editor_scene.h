// What the window shows of the object: the scene an Editor's state comes to.
#pragma once

#include "app/editor.h"
#include "render/renderer.h"

namespace pectin {

// pixel_scale: pixels a unit of window coordinates, times the screen's scale.
Scene editor_scene(const Editor& editor, float pixel_scale);

}  // namespace pectin

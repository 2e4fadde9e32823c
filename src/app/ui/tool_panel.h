// The panel on the left, with the settings of the brush and of drags.
#pragma once

#include "app/editor.h"

namespace pectin {

class ToolPanel {
  public:
    // To be called within a window of Dear ImGui. scale: of the screen.
    void draw(Editor& editor, float scale);
};

}  // namespace pectin

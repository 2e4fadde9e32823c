// The panel on the left, with the settings of the brush and of drags.
#pragma once

#include <optional>

#include "app/editor.h"

namespace pectin {

class ToolPanel {
  public:
    // To be called within a window of Dear ImGui. scale: of the screen. available: height for the
    // panel, in pixels.
    void draw(Editor& editor, float scale, float available);

  private:
    void draw_radius(Editor& editor, float width, float height);

    std::optional<float> edited_radius_;
};

}  // namespace pectin

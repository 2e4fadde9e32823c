// The panel on the left: how far a drag reaches, and what it does.
#pragma once

#include <optional>

#include "app/editor.h"

namespace pectin {

class ToolPanel {
  public:
    // Within a window of Dear ImGui. scale: of the screen; room: for all of it, in pixels.
    void draw(Editor& editor, float scale, float available);

  private:
    void draw_radius(Editor& editor, float width, float height);

    std::optional<float> edited_radius_;
};

}  // namespace pectin

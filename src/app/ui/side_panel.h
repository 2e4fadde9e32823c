// The panel on the right: sections with all settings, each of which can be folded.
#pragma once

#include "app/editor.h"
#include "app/ui/brush_panel.h"
#include "app/ui/cage_panel.h"
#include "app/ui/detail_panel.h"

namespace pectin {

class SidePanel {
  public:
    // Draws the contents into the present window of Dear ImGui, which scrolls if there is not
    // enough space.
    void draw(Editor& editor);
    // Updates what the editor previews of the settings. To be called in each frame, also if the
    // panel is hidden.
    void update_preview(Editor& editor);

  private:
    BrushPanel brush_;
    DetailPanel detail_;
    CagePanel cage_;
};

}  // namespace pectin

// The windows of the menu Help.
#pragma once

#include <string>
#include <utility>

#include "app/editor.h"
#include "app/ui/command_palette.h"
#include "app/ui/help_overlay.h"
#include "app/ui/reference_window.h"

namespace pectin {

class HelpWindows {
  public:
    // Draws the one that is open. To be called in every frame. scale: of the screen.
    void draw(Editor& editor, float scale);
    // What draws the pictures, as OpenGL describes it.
    void set_renderer(std::string renderer) { renderer_ = std::move(renderer); }

  private:
    HelpOverlay inputs_;
    CommandPalette actions_;
    ReferenceWindow reference_;
    std::string renderer_;
};

}  // namespace pectin

// The window with the commands of scripts and all their fields, as the table in the README has
// them.
#pragma once

#include <string>

#include "app/editor.h"

namespace pectin {

class ReferenceWindow {
  public:
    // Draws the window while it is open. scale: of the screen.
    void draw(Editor& editor, float scale);

  private:
    std::string search_;
};

}  // namespace pectin

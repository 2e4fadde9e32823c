// The window that lists everything that the mouse and the keys do.
#pragma once

#include <string>
#include <vector>

#include "app/editor.h"
#include "app/input_reference.h"

namespace pectin {

class HelpOverlay {
  public:
    // Draws the window while it is open. scale: of the screen.
    void draw(Editor& editor, float scale);

  private:
    void draw_columns() const;

    std::vector<InputSection> sections_;
    std::string search_;
};

}  // namespace pectin

// The line at the bottom: what the mouse does here and now, and figures of the object.
#pragma once

#include <cstddef>

#include "app/editor.h"

namespace pectin {

// Figures that only the renderer of the frames knows.
struct PictureFigures {
    std::size_t uploaded_bytes = 0, uploaded_ranges = 0;  // in the last frame with an upload
    std::size_t memory_bytes = 0;                         // used by the whole program
};

class StatusLine {
  public:
    // Draws the line into the present window of Dear ImGui, which is as wide as the display.
    // scale: of the screen and the user together.
    void draw(const Editor& editor, const PictureFigures& picture, float scale);

    // Whether the line shows the present message, which is then shown nowhere else.
    bool shows_message() const { return shows_message_; }

  private:
    void draw_text(const Editor& editor, float end);

    bool shows_message_ = false;
};

}  // namespace pectin

// The window with the program's version, its licence, and what it is built on.
#pragma once

#include <string>

#include "app/editor.h"

namespace pectin {

// Draws the window while it is open. renderer: what draws the pictures, or an empty text if that is
// not known. scale: of the screen.
void draw_about_dialog(Editor& editor, const std::string& renderer, float scale);

}  // namespace pectin

// The questions that the window asks before changes would be lost, or about a session that was.
#pragma once

#include "app/editor.h"

namespace pectin {

// Draws the question that is being asked, if any. scale: of the screen and the user together.
void draw_questions(Editor& editor, float scale);

}  // namespace pectin

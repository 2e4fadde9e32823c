// The dialog that shows the progress of work in the background.
#pragma once

#include "app/editor.h"

namespace pectin {

// Draws the dialog while the editor is working. The work can be cancelled there. scale: of the
// screen.
void draw_progress_panel(Editor& editor, float scale);

}  // namespace pectin

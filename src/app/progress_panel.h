// A file that is under way, or a session that is being restored, as a dialog.
#pragma once

#include "app/editor.h"

namespace pectin {

// While the editor has one; it can be cancelled there. scale: of the screen.
void draw_progress_panel(Editor& editor, float scale);

}  // namespace pectin

// The file browser as a dialog.
#pragma once

#include "app/editor.h"

namespace pectin {

// While the editor has a browser open; also asks before a file is replaced. scale: of the screen.
void draw_file_panel(Editor& editor, float scale);

// Opens the popup if it is not, in the middle of the window and over all else, and begins it.
// Ends with ImGui::EndPopup where it answers true.
bool begin_dialog(const char* title, float width, float height);

}  // namespace pectin

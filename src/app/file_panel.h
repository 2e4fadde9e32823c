// The file browser as a dialog.
#pragma once

#include "app/editor.h"

namespace pectin {

// While the editor has a browser open; also asks before a file is replaced. scale: of the screen.
void draw_file_panel(Editor& editor, float scale);

// Begins a dialog in the middle of the window and over all else, opening it first; closes it where
// it is not wanted. To be called every frame; where it answers true, ImGui::EndPopup ends it.
bool begin_dialog(bool is_wanted, const char* title, float width, float height);

}  // namespace pectin

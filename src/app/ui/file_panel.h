// The dialog of the file browser.
#pragma once

#include "app/document_controller.h"

namespace pectin {

// Draws the browser while it is open, and the question whether to replace a file.
// scale: of the screen.
void draw_file_panel(DocumentController& document, float scale);

// Begins a modal dialog in the middle of the window, opening it first if need be. If it is not
// wanted, closes it. To be called in every frame. If it returns true, ImGui::EndPopup() must
// follow.
bool begin_dialog(bool is_wanted, const char* title, float width, float height);

}  // namespace pectin

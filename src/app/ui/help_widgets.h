// What the windows of the menu Help have in common: a dialog with a field to search, contents that
// scroll, and a button that closes it. A click beside the window closes it, too.
#pragma once

#include <string>

namespace pectin {

// As begin_dialog() of file_panel.h.
bool begin_help_window(bool is_open, const char* title, float width, float height);
// Returns whether the window is to be closed. To be called if begin_help_window() returned true.
bool end_help_window();

// A field for a text to search. It has the keyboard focus when the window opens. Returns whether
// the text was changed.
bool draw_search(const char* hint, std::string& text);

// The part that scrolls, above the button.
void begin_help_contents();
void end_help_contents();

}  // namespace pectin

// Rows of a panel: a label on the left and a control beside it, with the same edges in all rows.
//
// Precondition of all functions: a window of Dear ImGui is being laid out.
#pragma once

#include <array>

namespace pectin {

// Draws the label. The next item fills the rest of the row, or the row below where the label needs
// all of this one.
void begin_row(const char* label);
// Where the controls of rows begin, in pixels from the left edge of the window.
float row_indent();

// Draws the names of three columns that share the space of a control, such as x, y and z.
void draw_column_names(const std::array<const char*, 3>& names);
// The width of each of these columns.
float third_of_row();

// A text in several lines that explains something.
void draw_note(const char* text);
// The same as a warning.
void draw_warning(const char* text);

}  // namespace pectin

// Colours, sizes and fonts of the panels. All of them are part of the current Dear ImGui context.
#pragma once

#include <imgui.h>

#include "app/preferences.h"

namespace pectin {

// Sets the colours and the sizes. scale: of the screen and the user together, 1 on an ordinary
// screen.
void apply_theme(Theme theme, float scale);
// Loads the fonts and builds their texture, which has to be uploaded anew afterwards.
// Precondition: no frame is being laid out.
void load_fonts(float scale);

// The bolder font of headings.
ImFont* heading_font();

// Colours of the theme that Dear ImGui has no names for.
enum class ThemeColour {
    warning,         // text that warns
    warning_border,  // of a box that warns
    accent,          // what is on
    on_accent,       // text and icons on the accent
    fill,            // the filled part of a number's field
    selection        // the box with which a tool selects
};
ImVec4 theme_colour(ThemeColour colour);

}  // namespace pectin

#include "app/ui/help_windows.h"

#include "app/ui/about_dialog.h"

namespace pectin {

void HelpWindows::draw(Editor& editor, float scale) {
    inputs_.draw(editor, scale);
    actions_.draw(editor, scale);
    reference_.draw(editor, scale);
    draw_about_dialog(editor, renderer_, scale);
}

}  // namespace pectin

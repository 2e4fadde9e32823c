#include "app/ui/side_panel.h"

#include <string>

#include "app/ui/action_widgets.h"
#include "app/ui/theme.h"

namespace pectin {
namespace {

// Draws a section: its heading and, unless it is folded, its contents. Controls of the contents may
// be called like the section.
template <typename Contents>
void section(const char* name, const char* help, Contents draw) {
    ImGui::PushFont(heading_font());
    const bool is_open = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopFont();
    tooltip((std::string(name) + " section").c_str(), help);
    if (!is_open) return;
    ImGui::PushID(name);
    draw();
    ImGui::PopID();
}

void draw_display(Editor& editor) {
    action_checkbox(editor, Action::toggle_wireframe);
    action_checkbox(editor, Action::toggle_levels);
    action_checkbox(editor, Action::toggle_lattice);
    action_checkbox(editor, Action::toggle_drag_lattice);
    action_checkbox(editor, Action::toggle_symmetry_plane);
}

}  // namespace

void SidePanel::draw(Editor& editor) {
    section("Brush", "How far drags reach and how they act.", [&] { brush_.draw(editor); });
    section("Detail", "How fine drags make the mesh.", [&] { detail_.draw(editor); });
    if (editor.shown_settings().cage) {
        section("Cage", "A box of control points around the object.", [&] { cage_.draw(editor); });
    }
    section("Display", "What is shown of the object.", [&] { draw_display(editor); });
}

void SidePanel::update_preview(Editor& editor) {
    editor.detail_preview.set(detail_.take_preview());
}

}  // namespace pectin

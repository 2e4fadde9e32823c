#include "app/ui/side_panel.h"

#include <string>

#include "app/ui/action_widgets.h"
#include "app/ui/theme.h"

namespace pectin {
namespace {

// Draws the heading of a section. Returns whether the section is open.
bool begin_section(const char* name, const char* help) {
    ImGui::PushFont(heading_font());
    const bool is_open = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopFont();
    tooltip((std::string(name) + " section").c_str(), help);
    return is_open;
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
    if (begin_section("Brush", "How far drags reach and how they act.")) brush_.draw(editor);
    if (begin_section("Detail", "How fine drags make the mesh.")) detail_.draw(editor);
    if (editor.shown_settings().cage &&
        begin_section("Cage", "A box of control points around the object.")) {
        cage_.draw(editor);
    }
    if (begin_section("Display", "What is shown of the object.")) draw_display(editor);
}

void SidePanel::update_preview(Editor& editor) {
    editor.detail_preview.set(detail_.take_preview());
}

}  // namespace pectin

#include "app/ui/about_dialog.h"

#include <imgui.h>

#include "app/libraries.h"
#include "app/ui/help_widgets.h"

namespace pectin {
namespace {

constexpr float kWidth = 560.0f, kHeight = 600.0f;
constexpr float kNameWidth = 9.0f;  // of the first column, in heights of the font

void draw_heading(const char* text) {
    ImGui::Spacing();
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", text);
}

void draw_libraries() {
    if (!ImGui::BeginTable("libraries", 2)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed,
                            kNameWidth * ImGui::GetFontSize());
    for (const Library& library : libraries()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(library.name.c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(library.version.c_str());
    }
    ImGui::EndTable();
}

}  // namespace

void draw_about_dialog(Editor& editor, const std::string& renderer, float scale) {
    const bool is_open = editor.help_page() == HelpPage::about;
    if (!begin_help_window(is_open, "About pectin", kWidth * scale, kHeight * scale)) return;
    begin_help_contents();
    ImGui::Text("pectin %s", program_version().c_str());
    ImGui::TextWrapped("Sculpt by dragging points of an object set in jelly.");
    draw_heading("Licence");
    ImGui::TextWrapped("MIT: free to use, change and pass on. Copyright 2026 the pectin authors.");
    draw_heading("Method");
    ImGui::TextWrapped(
        "J. E. Gain and N. A. Dodgson, Adaptive Refinement and Decimation under Free-Form "
        "Deformation (1999).");
    draw_heading("Renderer");
    ImGui::TextWrapped("%s", renderer.empty() ? "not available" : renderer.c_str());
    draw_heading("Libraries");
    draw_libraries();
    end_help_contents();
    if (end_help_window()) editor.close_help();
}

}  // namespace pectin

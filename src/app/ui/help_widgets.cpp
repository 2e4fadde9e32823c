#include "app/ui/help_widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/ui/action_widgets.h"
#include "app/ui/file_panel.h"

namespace pectin {
namespace {

constexpr float kButtonWidth = 7.0f;  // in heights of the font

bool is_clicked_outside() {
    return ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowAppearing() &&
           !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows |
                                   ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

}  // namespace

bool begin_help_window(bool is_open, const char* title, float width, float height) {
    return begin_dialog(is_open, title, width, height);
}

bool end_help_window() {
    const float width = kButtonWidth * ImGui::GetFontSize();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    const bool closes = ImGui::Button("Close", ImVec2(width, 0.0f));
    tooltip("Close", "Close this window, as Esc does.");
    const bool is_left = is_clicked_outside();
    ImGui::EndPopup();
    return closes || is_left;
}

bool draw_search(const char* hint, std::string& text) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const bool is_changed = ImGui::InputTextWithHint("##search", hint, &text);
    tooltip("Search", "Type some letters to shorten the list.");
    return is_changed;
}

void begin_help_contents() {
    ImGui::BeginChild("contents", ImVec2(0.0f, -ImGui::GetFrameHeightWithSpacing()), false);
}

void end_help_contents() { ImGui::EndChild(); }

}  // namespace pectin

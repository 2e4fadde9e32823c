#include "app/ui/action_widgets.h"

#include <imgui.h>

namespace pectin {
namespace {

constexpr float kTooltipWidth = 26.0f;  // in heights of the font

}  // namespace

void tooltip(const char* text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(kTooltipWidth * ImGui::GetFontSize());
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void tooltip_of(Action action) { tooltip(tooltip_with_shortcuts(action).c_str()); }

bool toggle_button(const char* label, bool is_on, float width) {
    if (is_on) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.62f, 0.42f, 0.18f, 1.0f));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImVec4(0.70f, 0.48f, 0.21f, 1.0f));
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.97f, 0.92f, 1.0f));
    }
    const bool is_pressed = ImGui::Button(label, ImVec2(width, 0.0f));
    if (is_on) ImGui::PopStyleColor(3);
    return is_pressed;
}

void action_button(Editor& editor, Action action, float width, const char* label) {
    const ActionInfo& info = info_of(action);
    ImGui::BeginDisabled(!info.is_enabled(editor));
    const bool is_pressed = toggle_button(label ? label : info.name, info.is_on(editor), width);
    ImGui::EndDisabled();
    tooltip_of(action);
    if (is_pressed) editor.perform(action);
}

void action_checkbox(Editor& editor, Action action) {
    const ActionInfo& info = info_of(action);
    bool is_on = info.is_on(editor);
    ImGui::BeginDisabled(!info.is_enabled(editor));
    const bool is_changed = ImGui::Checkbox(info.name, &is_on);
    ImGui::EndDisabled();
    tooltip_of(action);
    if (is_changed) editor.perform(action);
}

}  // namespace pectin

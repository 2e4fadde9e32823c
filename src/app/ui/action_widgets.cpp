#include "app/ui/action_widgets.h"

#include <cfloat>
#include <string>

#include "app/ui/controls.h"
#include "app/ui/theme.h"

namespace pectin {
namespace {

constexpr float kTooltipWidth = 26.0f;  // in heights of the font
constexpr float kIconSize = 0.64f;      // of the button that it is on
constexpr float kTooltipGap = 6.0f;     // between a button and the tooltip to its right

bool is_on(const Editor& editor, const ActionInfo& info) {
    return info.is_on && info.is_on(editor);
}

// Whether to show a tooltip of the last item: not while something is dragged or typed, which the
// tooltip could hide.
bool wants_tooltip() {
    return ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsAnyItemActive() &&
           !ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

void wrapped(const char* text) {
    ImGui::PushTextWrapPos(kTooltipWidth * ImGui::GetFontSize());
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
}

void icon_tooltip(Action action) {
    const ActionInfo& info = info_of(action);
    ControlList::add_last_item(info.name, info.tooltip);
    if (!wants_tooltip()) return;
    ImGui::SetNextWindowPos(
        ImVec2(ImGui::GetItemRectMax().x + kTooltipGap, ImGui::GetItemRectMin().y));
    ImGui::BeginTooltip();
    ImGui::PushFont(heading_font());
    ImGui::TextUnformatted(info.name);
    ImGui::PopFont();
    if (const std::string keys = shortcut_labels(action); !keys.empty()) {
        ImGui::SameLine();
        ImGui::TextDisabled("%s", keys.c_str());
    }
    wrapped(info.tooltip);
    ImGui::EndTooltip();
}

}  // namespace

void tooltip(const char* name, const char* text) {
    ControlList::add_last_item(name, text);
    if (!wants_tooltip()) return;
    ImGui::BeginTooltip();
    wrapped(text);
    ImGui::EndTooltip();
}

void tooltip_of(Action action) {
    tooltip(info_of(action).name, tooltip_with_shortcuts(action).c_str());
}

bool toggle_button(const char* label, bool is_on, float width) {
    if (is_on) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme_colour(ThemeColour::accent));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme_colour(ThemeColour::accent));
        ImGui::PushStyleColor(ImGuiCol_Text, theme_colour(ThemeColour::on_accent));
    }
    const bool is_pressed = ImGui::Button(label, ImVec2(width, 0.0f));
    if (is_on) ImGui::PopStyleColor(3);
    return is_pressed;
}

void action_button(Editor& editor, Action action, float width) {
    const ActionInfo& info = info_of(action);
    ImGui::BeginDisabled(!info.is_enabled(editor));
    // Dear ImGui leaves so much space to the right of a negative width.
    const float exact = width < 0.0f ? -FLT_MIN : width;
    const bool is_pressed = toggle_button(info.name, is_on(editor, info), exact);
    ImGui::EndDisabled();
    tooltip_of(action);
    if (is_pressed) editor.perform(action);
}

void action_checkbox(Editor& editor, Action action) {
    const ActionInfo& info = info_of(action);
    bool checked = is_on(editor, info);
    ImGui::BeginDisabled(!info.is_enabled(editor));
    const bool is_changed = ImGui::Checkbox(info.name, &checked);
    ImGui::EndDisabled();
    tooltip_of(action);
    if (is_changed) editor.perform(action);
}

void icon_button(Editor& editor, Action action, Icon icon, float size) {
    const ActionInfo& info = info_of(action);
    const bool on = is_on(editor, info);
    ImGui::BeginDisabled(!info.is_enabled(editor));
    ImGui::PushID(info.name);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? theme_colour(ThemeColour::accent) : ImVec4());
    if (on) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme_colour(ThemeColour::accent));
    const bool is_pressed = ImGui::Button("##icon", ImVec2(size, size));
    ImGui::PopStyleColor(on ? 2 : 1);
    ImGui::PopID();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec4 colour =
        on ? theme_colour(ThemeColour::on_accent) : ImGui::GetStyleColorVec4(ImGuiCol_Text);
    draw_icon(*ImGui::GetWindowDrawList(), icon,
              ImVec2(0.5f * (low.x + high.x), 0.5f * (low.y + high.y)), kIconSize * size,
              ImGui::GetColorU32(colour));  // fainter while it is disabled
    ImGui::EndDisabled();
    icon_tooltip(action);
    if (is_pressed) editor.perform(action);
}

}  // namespace pectin

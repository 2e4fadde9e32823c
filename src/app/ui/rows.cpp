#include "app/ui/rows.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/theme.h"

namespace pectin {
namespace {

constexpr float kLabelFraction = 0.40f;  // of the width of the contents
constexpr float kMostLabelWidth = 8.5f;  // in heights of the font

void draw_wrapped(const char* text, const ImVec4& colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

}  // namespace

float row_indent() {
    const float left = ImGui::GetWindowContentRegionMin().x;
    const float width = ImGui::GetContentRegionMax().x - left;
    return left + std::min(kLabelFraction * width, kMostLabelWidth * ImGui::GetFontSize());
}

void begin_row(const char* label) {
    float begin = row_indent();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine();
    if (ImGui::GetCursorPosX() > begin) {
        ImGui::NewLine();
        begin = ImGui::GetWindowContentRegionMin().x;
    }
    ImGui::SetCursorPosX(begin);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionMax().x - begin);
}

float third_of_row() {
    const float available =
        ImGui::GetContentRegionMax().x - row_indent() - 2.0f * ImGui::GetStyle().ItemInnerSpacing.x;
    return std::floor(available / 3.0f);
}

void draw_column_names(const std::array<const char*, 3>& names) {
    const float width = third_of_row(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    float left = row_indent();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        ImGui::SetCursorPosX(left + 0.5f * (width - ImGui::CalcTextSize(names[i]).x));
        ImGui::TextDisabled("%s", names[i]);
        left += width + gap;
    }
}

void draw_note(const char* text) {
    draw_wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
}

void draw_warning(const char* text) { draw_wrapped(text, theme_colour(ThemeColour::warning)); }

}  // namespace pectin

#include "app/ui/help_overlay.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>

#include "app/fuzzy_match.h"
#include "app/ui/action_widgets.h"
#include "app/ui/columns.h"
#include "app/ui/help_widgets.h"

namespace pectin {
namespace {

constexpr float kWidth = 1180.0f, kHeight = 660.0f;
// In heights of the font.
constexpr float kColumnWidth = 22.0f, kInputWidth = 9.0f;
constexpr float kLineGap = 2.0f;  // above and below each line

bool matches(const InputSection& section, const InputLine& line, const std::string& search) {
    return contains_text(line.input, search) || contains_text(line.effect, search) ||
           contains_text(section.title, search);
}

std::vector<InputSection> found(const std::vector<InputSection>& sections,
                                const std::string& search) {
    std::vector<InputSection> left = sections;
    for (InputSection& section : left) {
        std::erase_if(section.lines,
                      [&](const InputLine& line) { return !matches(section, line, search); });
    }
    std::erase_if(left, [](const InputSection& section) { return section.lines.empty(); });
    return left;
}

void draw_section(const InputSection& section) {
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", section.title.c_str());
    if (!ImGui::BeginTable(section.title.c_str(), 2)) return;
    ImGui::TableSetupColumn("input", ImGuiTableColumnFlags_WidthFixed,
                            kInputWidth * ImGui::GetFontSize());
    ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthStretch);
    for (const InputLine& line : section.lines) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", line.input.c_str());
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        ImGui::TextWrapped("%s", line.effect.c_str());
        ImGui::PopStyleColor();
        if (!line.detail.empty()) tooltip(line.input.c_str(), line.detail.c_str());
    }
    ImGui::EndTable();
    ImGui::Spacing();
}

// The height of a section in a column of this width.
float height_of(const InputSection& section, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float input = kInputWidth * ImGui::GetFontSize();
    const float effect = width - input - 4.0f * style.CellPadding.x;
    const auto wrapped = [](const std::string& text, float wrap) {
        return ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap).y;
    };
    float height = ImGui::GetTextLineHeight() + 2.0f * style.ItemSpacing.y;
    for (const InputLine& line : section.lines) {
        height += std::max(wrapped(line.input, input), wrapped(line.effect, effect)) +
                  2.0f * style.CellPadding.y;
    }
    return height;
}

// Draws the sections in columns of about the same height, in a table that has been begun.
void fill_columns(const std::vector<InputSection>& sections, std::size_t columns, float width) {
    std::vector<float> heights;
    for (const InputSection& section : sections) heights.push_back(height_of(section, width));
    const std::vector<std::size_t> column_of = balanced_columns(heights, columns);
    ImGui::TableNextRow();
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (i == 0 || column_of[i] != column_of[i - 1]) {
            ImGui::TableSetColumnIndex(static_cast<int>(column_of[i]));
        }
        draw_section(sections[i]);
    }
}

}  // namespace

void HelpOverlay::draw(Editor& editor, float scale) {
    const bool is_open = editor.help_page() == HelpPage::inputs;
    if (!begin_help_window(is_open, "Mouse and keys", kWidth * scale, kHeight * scale)) return;
    if (ImGui::IsWindowAppearing()) {
        sections_ = input_sections(editor.preferences.mouse);
        search_.clear();
    }
    draw_search("Search", search_);
    begin_help_contents();
    draw_columns();
    end_help_contents();
    if (end_help_window()) editor.close_help();
}

void HelpOverlay::draw_columns() const {
    const std::vector<InputSection> sections = found(sections_, search_);
    if (sections.empty()) return ImGui::TextDisabled("Nothing is called so.");
    const float available = ImGui::GetContentRegionAvail().x;
    const int columns =
        std::clamp(static_cast<int>(available / (kColumnWidth * ImGui::GetFontSize())), 1, 3);
    const float gap = ImGui::GetStyle().CellPadding.x;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(gap, kLineGap));
    if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) {
        fill_columns(sections, static_cast<std::size_t>(columns),
                     available / static_cast<float>(columns) - 2.0f * gap);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

}  // namespace pectin

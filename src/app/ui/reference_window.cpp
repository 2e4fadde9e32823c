#include "app/ui/reference_window.h"

#include <imgui.h>

#include <vector>

#include "app/fuzzy_match.h"
#include "app/ui/help_widgets.h"
#include "command/reference.h"

namespace pectin {
namespace {

constexpr float kWidth = 1000.0f, kHeight = 640.0f;
// Widths of columns, in heights of the font.
constexpr float kNameWidth = 9.5f, kValueWidth = 13.0f, kDefaultWidth = 8.5f;

struct Row {
    std::string name;
    const FieldReference* field;
};

void append_rows(const std::vector<FieldReference>& fields, const std::string& prefix,
                 std::vector<Row>& rows) {
    for (const FieldReference& field : fields) {
        rows.push_back({prefix + field.name, &field});
        append_rows(field.nested, prefix + field.name + ".", rows);
    }
}

bool matches(const Row& row, const std::string& search) {
    return contains_text(row.name, search) || contains_text(row.field->meaning, search);
}

bool matches(const CommandReference& command, const std::string& search) {
    return contains_text(command.name, search) || contains_text(command.meaning, search);
}

void draw_cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", text.c_str());
}

void draw_fields(const std::string& command, const std::vector<Row>& rows) {
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_PadOuterX;
    if (rows.empty() || !ImGui::BeginTable(command.c_str(), 4, kFlags)) return;
    const auto fixed = [](const char* name, float width) {
        ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed,
                                width * ImGui::GetFontSize());
    };
    fixed("field", kNameWidth);
    fixed("value", kValueWidth);
    fixed("default", kDefaultWidth);
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableHeadersRow();
    for (const Row& row : rows) {
        ImGui::TableNextRow();
        draw_cell(row.name);
        draw_cell(row.field->right);
        draw_cell(row.field->initial.value_or("required"));
        draw_cell(row.field->meaning);
    }
    ImGui::EndTable();
}

// Returns whether something of the command was found.
bool draw_command(const CommandReference& command, const std::string& search) {
    std::vector<Row> rows;
    append_rows(command.fields, "", rows);
    if (!matches(command, search)) {
        std::erase_if(rows, [&](const Row& row) { return !matches(row, search); });
        if (rows.empty()) return false;
    }
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", command.name.c_str());
    ImGui::TextWrapped("%s", command.meaning.c_str());
    draw_fields(command.name, rows);
    ImGui::Spacing();
    ImGui::Spacing();
    return true;
}

}  // namespace

void ReferenceWindow::draw(Editor& editor, float scale) {
    const bool is_open = editor.help_page() == HelpPage::reference;
    if (!begin_help_window(is_open, "Reference of scripts", kWidth * scale, kHeight * scale)) {
        return;
    }
    if (ImGui::IsWindowAppearing()) search_.clear();
    draw_search("Search", search_);
    begin_help_contents();
    bool is_found = false;
    for (const CommandReference& command : command_reference()) {
        is_found |= draw_command(command, search_);
    }
    if (!is_found) ImGui::TextDisabled("Nothing is called so.");
    end_help_contents();
    if (end_help_window()) editor.close_help();
}

}  // namespace pectin

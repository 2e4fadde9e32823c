#include "app/ui/command_palette.h"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "app/fuzzy_match.h"
#include "app/ui/action_widgets.h"
#include "app/ui/help_widgets.h"

namespace pectin {
namespace {

constexpr float kWidth = 620.0f, kHeight = 460.0f;

// A match in the name counts more than one in the menu's title.
std::optional<int> score_of(const std::string& query, const ActionInfo& info) {
    constexpr int kNameFirst = 1'000'000;
    if (const auto score = match_score(query, info.name)) return *score + kNameFirst;
    return match_score(query, menu_path(info.action) + " " + info.name);
}

void draw_right(const std::string& text, float right) {
    ImGui::SameLine(right - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextDisabled("%s", text.c_str());
}

// The menu and the shortcut of an action, or why it cannot be done, on the right of its name.
void draw_details(const ActionInfo& info, bool is_enabled) {
    const float right = ImGui::GetContentRegionMax().x - ImGui::GetStyle().FramePadding.x;
    const float keys = 7.5f * ImGui::GetFontSize();
    draw_right(is_enabled ? menu_path(info.action) : std::string(info.needs), right - keys);
    draw_right(shortcut_label(info.action), right);
}

}  // namespace

std::vector<Action> matching_actions(const std::string& query) {
    std::vector<std::pair<int, Action>> found;
    for (const ActionInfo& info : all_actions()) {
        if (const auto score = score_of(query, info)) found.emplace_back(*score, info.action);
    }
    if (query.find_first_not_of(' ') != query.npos) {
        std::ranges::stable_sort(found, std::greater{}, &std::pair<int, Action>::first);
    }
    std::vector<Action> actions;
    for (const auto& [score, action] : found) actions.push_back(action);
    return actions;
}

void CommandPalette::draw(Editor& editor, float scale) {
    const bool is_open = editor.help_page() == HelpPage::actions;
    if (!begin_help_window(is_open, "Find an action", kWidth * scale, kHeight * scale)) return;
    if (ImGui::IsWindowAppearing()) {
        query_.clear();
        selected_ = 0;
    }
    if (draw_search("Name of an action", query_)) selected_ = 0;
    const std::vector<Action> actions = matching_actions(query_);
    move_selection(actions.size());
    begin_help_contents();
    const bool is_chosen = draw_list(editor, actions);
    end_help_contents();
    const bool closes = end_help_window();
    if (closes || is_chosen) editor.close_help();
    if (is_chosen) editor.perform(actions[selected_]);
}

void CommandPalette::move_selection(std::size_t count) {
    const std::size_t before = selected_;
    if (ImGui::IsKeyPressed(ImGuiKey_DownArrow) && selected_ + 1 < count) ++selected_;
    if (ImGui::IsKeyPressed(ImGuiKey_UpArrow) && selected_ > 0) --selected_;
    has_moved_ = selected_ != before;
    if (selected_ >= count) selected_ = 0;
}

// Returns whether the selected action is to be performed.
bool CommandPalette::draw_list(const Editor& editor, const std::vector<Action>& actions) {
    if (actions.empty()) ImGui::TextDisabled("No action has such a name.");
    bool is_chosen = ImGui::IsKeyPressed(ImGuiKey_Enter, false) && !actions.empty();
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const bool has_mouse_moved = moved.x != 0.0f || moved.y != 0.0f;
    ImGui::Indent(ImGui::GetStyle().FramePadding.x);
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const ActionInfo& info = info_of(actions[i]);
        const bool is_enabled = info.is_enabled(editor);
        ImGui::PushStyleColor(
            ImGuiCol_Text,
            ImGui::GetStyleColorVec4(is_enabled ? ImGuiCol_Text : ImGuiCol_TextDisabled));
        if (ImGui::Selectable(info.name, i == selected_)) {
            selected_ = i;
            is_chosen = true;
        }
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered() && has_mouse_moved) selected_ = i;
        tooltip(info.name, info.tooltip);
        if (i == selected_ && has_moved_) ImGui::SetScrollHereY();
        draw_details(info, is_enabled);
    }
    return is_chosen && info_of(actions[selected_]).is_enabled(editor);
}

}  // namespace pectin

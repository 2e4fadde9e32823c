#include "app/ui/menu_bar.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "app/ui/action_widgets.h"
#include "app/ui/figure_text.h"

namespace pectin {
namespace {

// The limits that the menu offers, in bytes.
constexpr std::array<std::size_t, 5> kUndoLimits{100'000'000, 300'000'000, History::kDefaultLimit,
                                                 3'000'000'000, 10'000'000'000};

void draw_undo_limits(Editor& editor) {
    const ObjectFigures object = editor.workspace().object_figures();
    ImGui::TextDisabled("%s in use", undo_memory(object).c_str());
    ImGui::Separator();
    const auto choice = [&](const std::string& label, std::optional<std::size_t> limit) {
        if (!ImGui::MenuItem(label.c_str(), nullptr, object.undo_limit == limit)) return;
        const double number = 1e-6 * static_cast<double>(limit.value_or(0));
        editor.execute(command::History{limit ? Setting::of(number) : Setting::off()});
    };
    for (const std::size_t limit : kUndoLimits) choice(megabytes(limit), limit);
    choice("No limit", std::nullopt);
}

}  // namespace

void MenuBar::draw(Editor& editor) {
    hovered_.reset();
    open_.reset();
    has_submenu_ = is_at_submenu_ = false;
    if (std::exchange(editor.menus_requested, false)) requested_ = 0;
    if (requested_) ImGui::OpenPopup(menu_title(kMenuBar[*requested_]));
    requested_.reset();
    for (std::size_t i = 0; i < kMenuBar.size(); ++i) {
        if (ImGui::IsPopupOpen(menu_title(kMenuBar[i]))) open_ = i;
        draw_menu(editor, kMenuBar[i]);
    }
}

bool MenuBar::take_key(Key key) {
    if (!open_ || (key != Key::left && key != Key::right)) return false;
    const bool is_right = key == Key::right;
    // Left closes a submenu, and Right opens the one that the arrow keys are at.
    if (has_submenu_ ? !is_right : is_at_submenu_ && is_right) return false;
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (has_submenu_ && context.NavDisableHighlight) {
        // The cursor has opened it. The keys begin at its first entry.
        context.NavDisableHighlight = false;
        context.NavDisableMouseHover = true;
        return true;
    }
    const std::size_t step = is_right ? 1 : kMenuBar.size() - 1;
    requested_ = (*open_ + step) % kMenuBar.size();
    return true;
}

void MenuBar::draw_menu(Editor& editor, Menu menu) {
    if (!ImGui::BeginMenu(menu_title(menu))) return;
    if (menu == Menu::undo_memory) {
        draw_undo_limits(editor);
    } else {
        draw_entries(editor, menu);
    }
    ImGui::EndMenu();
}

void MenuBar::draw_submenu(Editor& editor, Menu menu) {
    has_submenu_ |= ImGui::IsPopupOpen(menu_title(menu));
    draw_menu(editor, menu);
    is_at_submenu_ |= ImGui::IsItemHovered();
}

void MenuBar::draw_entries(Editor& editor, Menu menu) {
    for (const ActionInfo& info : all_actions()) {
        if (info.menu != menu) continue;
        if (info.submenu_before) draw_submenu(editor, *info.submenu_before);
        if (info.begins_group) ImGui::Separator();
        draw_entry(editor, info);
    }
}

void MenuBar::draw_entry(Editor& editor, const ActionInfo& info) {
    const bool is_chosen =
        ImGui::MenuItem(info.name, shortcut_label(info.action).c_str(),
                        info.is_on && info.is_on(editor), info.is_enabled(editor));
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        hovered_ = info.action;
        // Beside the menu, so that the tooltip hides no entry.
        ImGui::SetNextWindowPos(
            ImVec2(ImGui::GetWindowPos().x + ImGui::GetWindowSize().x, ImGui::GetItemRectMin().y));
        tooltip_of(info.action);
    }
    if (is_chosen) editor.perform(info.action);
}

}  // namespace pectin

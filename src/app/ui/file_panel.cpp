#include "app/ui/file_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/ui/action_widgets.h"
#include "io/printable.h"

namespace pectin {
namespace {

constexpr ImGuiWindowFlags kDialog = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;

std::string size_text(std::uintmax_t bytes) {
    constexpr std::array kUnits{"B", "KB", "MB", "GB", "TB"};
    double amount = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; amount >= 1000.0 && unit + 1 < kUnits.size(); ++unit) amount /= 1000.0;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), unit == 0 ? "%.0f %s" : "%.1f %s", amount,
                  kUnits[unit]);
    return text.data();
}

// A row of buttons that lead to the folders above.
void draw_breadcrumbs(FileBrowser& browser) {
    std::optional<std::string> target;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const auto crumbs = browser.breadcrumbs();
    for (std::size_t i = 0; i < crumbs.size(); ++i) {
        const float width =
            ImGui::CalcTextSize(crumbs[i].name.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
        if (i > 0) {
            ImGui::SameLine(0.0f, 3.0f);
            if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
        }
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Button(crumbs[i].name.c_str())) target = crumbs[i].path;
        tooltip(crumbs[i].name.c_str(), "Go to this folder.");
        ImGui::PopID();
    }
    if (target) browser.open_folder(*target);
}

// Returns whether a file was chosen by a double click.
bool draw_entries(FileBrowser& browser) {
    bool chosen = false;
    std::optional<std::string> folder;
    if (browser.entries().empty()) {
        std::string types;
        for (const std::string& extension : browser.extensions()) {
            types += (types.empty() ? "" : " or ") + extension;
        }
        ImGui::TextDisabled("There are no folders and no %s files here.", types.c_str());
    }
    for (const FileEntry& entry : browser.entries()) {
        const bool is_selected = !entry.is_folder && entry.name == browser.name;
        const std::string label = entry.is_folder ? entry.name + "/" : entry.name;
        if (ImGui::Selectable(label.c_str(), is_selected, ImGuiSelectableFlags_AllowDoubleClick)) {
            if (entry.is_folder) {
                folder = browser.folder() + "/" + entry.name;
            } else {
                browser.name = entry.name;
                chosen = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
            }
        }
        tooltip(label.c_str(),
                entry.is_folder ? "Click to open the folder." : "Double-click to use this file.");
        if (entry.is_folder) continue;
        const std::string size = size_text(entry.bytes);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(size.c_str()).x);
        ImGui::TextDisabled("%s", size.c_str());
    }
    if (folder) browser.open_folder(*folder);
    return chosen;
}

void draw_replace_question(DocumentController& document, float scale) {
    const bool is_wanted = !document.file_to_replace().empty();
    const std::string name = std::filesystem::path(document.file_to_replace()).filename().string();
    const std::string title = "Replace " + printable(name) + "?###replace question";
    if (!begin_dialog(is_wanted, title.c_str(), 460.0f * scale, 0.0f)) return;
    ImGui::TextWrapped("%s already exists. Replace it?", printable(name).c_str());
    ImGui::Spacing();
    const ImVec2 size(110.0f * scale, 0.0f);
    const bool replaces = ImGui::Button("Replace", size);
    tooltip("Replace", "Save over the file. (Enter)");
    ImGui::SameLine();
    if (ImGui::Button("Keep it", size)) document.keep_file();
    tooltip("Keep it", "Choose another name. (Esc)");
    if (replaces || document.take_enter()) document.accept_file();
    ImGui::EndPopup();
}

}  // namespace

bool begin_dialog(bool is_wanted, const char* title, float width, float height) {
    if (!is_wanted) {
        if (!ImGui::IsPopupOpen(title)) return false;
        // In its last frame a closing dialog must be invisible. With alpha 0 it would not begin.
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1e-3f);
        if (ImGui::BeginPopupModal(title, nullptr, kDialog)) {
            ImGui::CloseCurrentPopup();
            ImGui::EndPopup();
        }
        ImGui::PopStyleVar();
        return false;
    }
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, 0.5f * display.y), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(
        ImVec2(std::min(width, 0.94f * display.x), std::min(height, 0.9f * display.y)));
    return ImGui::BeginPopupModal(title, nullptr, kDialog);
}

void draw_file_panel(DocumentController& document, float scale) {
    // The part after ### identifies the dialog, which stays the same when its title changes.
    const std::string title =
        (document.browser() ? document.browser()->title() : std::string()) + "###files";
    if (!begin_dialog(document.browser() != nullptr, title.c_str(), 640.0f * scale,
                      520.0f * scale)) {
        return;
    }
    FileBrowser& browser = *document.browser();
    draw_breadcrumbs(browser);
    if (!browser.error().empty()) ImGui::TextWrapped("%s", browser.error().c_str());
    const float below = 2.0f * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("entries", ImVec2(0.0f, -below), true);
    bool accepts = draw_entries(browser);
    ImGui::EndChild();
    const bool has_enter = document.file_to_replace().empty() && document.take_enter();
    // Each folder has its own field, since a field that has the focus ignores changes of its text.
    ImGui::PushID(browser.folder().c_str());
    if (std::exchange(browser.wants_focus, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##name", "Name or path", &browser.name,
                             ImGuiInputTextFlags_AutoSelectAll);
    tooltip("Name", "The name of the file or its path, in which ~ is your home folder.");
    ImGui::PopID();
    const ImVec2 size(110.0f * scale, 0.0f);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * size.x -
                         ImGui::GetStyle().ItemSpacing.x);
    const bool cancels = ImGui::Button("Cancel", size);
    tooltip("Cancel", "Close without choosing a file. (Esc)");
    ImGui::SameLine();
    accepts |= ImGui::Button(browser.accept_label(), size) || has_enter;
    tooltip(browser.accept_label(), "Use the file that is named. (Enter)");
    draw_replace_question(document, scale);
    ImGui::EndPopup();
    // These may close the browser.
    if (document.browser() && accepts) document.accept_file();
    if (document.browser() && cancels) document.close_browser();
}

}  // namespace pectin

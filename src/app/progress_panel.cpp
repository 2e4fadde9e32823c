#include "app/progress_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "app/file_panel.h"

namespace pectin {
namespace {

// Shortens the text to the available width by leaving out its middle. No UTF-8 character is split.
std::string fitted(const std::string& text, float available) {
    const auto width = [](const std::string& part) { return ImGui::CalcTextSize(part.c_str()).x; };
    const auto is_inside = [&text](std::size_t at) {
        return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
    };
    std::string shown = text;
    for (std::size_t left_out = 1; width(shown) > available && left_out < text.size(); ++left_out) {
        std::size_t begin = (text.size() - left_out) / 2, end = begin + left_out;
        while (begin > 0 && is_inside(begin)) --begin;
        while (is_inside(end)) ++end;
        shown = text.substr(0, begin) + "…" + text.substr(end);
    }
    return shown;
}

void draw_bar(double fraction, float height) {
    std::array<char, 8> percent{};
    std::snprintf(percent.data(), percent.size(), "%.0f %%", 100.0 * fraction);
    const float available = ImGui::CalcTextSize("100 %").x + ImGui::GetStyle().ItemSpacing.x;
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorPos();
    ImGui::SetCursorPosY(at.y + 0.5f * (line - height));
    ImGui::ProgressBar(static_cast<float>(fraction), ImVec2(-available, height), "");
    // Aligns the percentage with the right edge of the button.
    ImGui::SetCursorPos(
        ImVec2(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(percent.data()).x, at.y));
    ImGui::TextUnformatted(percent.data());
}

}  // namespace

void draw_progress_panel(Editor& editor, float scale) {
    const FileTask* const task = editor.workspace().file_task();
    const Restoration* const restoration = editor.restoration();
    const auto* open = task ? std::get_if<command::Open>(&task->command) : nullptr;
    const auto* save = task ? std::get_if<command::Save>(&task->command) : nullptr;
    const char* const doing = restoration ? "Restoring" : save ? "Saving" : "Opening";
    // The part after ### identifies the dialog, which stays the same when its title changes.
    const std::string title = std::string(doing) + "###progress";
    if (!begin_dialog(editor.is_working(), title.c_str(), 420.0f * scale, 0.0f)) return;
    const std::filesystem::path path = save ? save->path : open ? open->path : "";
    const std::string name = restoration ? restoration->session().object : path.filename().string();
    ImGui::TextUnformatted(fitted(name, ImGui::GetContentRegionAvail().x).c_str());
    const double fraction = restoration ? restoration->fraction() : task->work.fraction();
    draw_bar(std::clamp(fraction, 0.0, 1.0), 8.0f * scale);
    ImGui::Spacing();
    const bool is_cancelled = restoration ? restoration->is_cancelled() : task->work.is_cancelled();
    const ImVec2 size(120.0f * scale, 0.0f);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - size.x);
    ImGui::BeginDisabled(is_cancelled);
    if (ImGui::Button(is_cancelled ? "Cancelling…" : "Cancel", size)) editor.cancel_work();
    ImGui::EndDisabled();
    ImGui::EndPopup();
}

}  // namespace pectin

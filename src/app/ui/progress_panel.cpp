#include "app/ui/progress_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "app/command_kind.h"
#include "app/ui/action_widgets.h"
#include "app/ui/file_panel.h"

namespace pectin {
namespace {

// A dialog for an edit that is soon done would only flicker.
constexpr std::chrono::milliseconds kHiddenTime{400};

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

// What the dialog shows about the work.
struct Work {
    const char* title;
    std::string text;
    std::optional<double> fraction{};  // none: not known
    bool is_cancelled = false;
};

Work describe(const Restoration& restoration) {
    return {"Restoring", restoration.session().object, restoration.fraction(),
            restoration.is_cancelled()};
}

Work describe(const FileTask& task) {
    const auto* const save = std::get_if<command::Save>(&task.command);
    const std::filesystem::path path =
        save ? save->path : std::get<command::Open>(task.command).path;
    return {save ? "Saving" : "Opening", path.filename().string(), task.work.fraction(),
            task.work.is_cancelled()};
}

const char* title_of(const EditTask& edit) {
    if (!edit.command()) return "Applying the drag";
    if (is_any_of<command::Undo>(*edit.command())) return "Undoing";
    if (is_any_of<command::Redo>(*edit.command())) return "Redoing";
    if (is_any_of<command::Bake>(*edit.command())) return "Keeping the triangles";
    return "Applying the detail";
}

Work describe(const EditTask& edit) {
    const double seconds = std::chrono::duration<double>(edit.duration()).count();
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%.0f s, %.2f million triangles", seconds,
                  1e-6 * static_cast<double>(edit.faces()));
    return {title_of(edit), text.data(), std::nullopt, edit.is_cancelled()};
}

// Nothing while there is no work, or it has only begun.
std::optional<Work> present_work(const Editor& editor) {
    if (const Restoration* restoration = editor.document().restoration())
        return describe(*restoration);
    if (const FileTask* task = editor.workspace().file_task()) return describe(*task);
    const EditTask* const edit = editor.workspace().edit_task();
    if (edit && edit->duration() >= kHiddenTime) return describe(*edit);
    return std::nullopt;
}

}  // namespace

void draw_progress_panel(Editor& editor, float scale) {
    const std::optional<Work> work = present_work(editor);
    // The part after ### identifies the dialog, which stays the same when its title changes.
    const std::string title = std::string(work ? work->title : "") + "###progress";
    if (!begin_dialog(work.has_value(), title.c_str(), 420.0f * scale, 0.0f)) return;
    ImGui::TextUnformatted(fitted(work->text, ImGui::GetContentRegionAvail().x).c_str());
    if (work->fraction) draw_bar(std::clamp(*work->fraction, 0.0, 1.0), 8.0f * scale);
    ImGui::Spacing();
    const ImVec2 size(120.0f * scale, 0.0f);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - size.x);
    ImGui::BeginDisabled(work->is_cancelled);
    if (ImGui::Button(work->is_cancelled ? "Cancelling…" : "Cancel", size))
        editor.document().cancel_work();
    tooltip("Cancel", "Stop, and leave everything as it was. (Esc)");
    ImGui::EndDisabled();
    ImGui::EndPopup();
}

}  // namespace pectin

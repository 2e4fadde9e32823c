#include "app/ui/panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/ui/action_widgets.h"
#include "app/ui/example_panel.h"
#include "app/ui/figure_text.h"
#include "app/ui/file_panel.h"
#include "app/ui/progress_panel.h"

namespace pectin {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
constexpr ImGuiWindowFlags kBare = kFixed | ImGuiWindowFlags_NoTitleBar |
                                   ImGuiWindowFlags_NoScrollbar |
                                   ImGuiWindowFlags_NoFocusOnAppearing;
constexpr float kMargin = 12.0f;  // between panels and the window's edge
constexpr float kSettingsWidth = 310.0f;

constexpr float kMessageGap = 12.0f;  // between a message and its close button

const ImVec4 kWarning(0.93f, 0.74f, 0.45f, 1.0f);
const ImVec4 kWarningBorder(0.86f, 0.62f, 0.34f, 0.8f);

std::array<std::string, 3> hint_lines() {
    return {"Drag a point of the surface. Its surroundings follow.",
            "Drag beside the object to orbit, with Shift to pan. The wheel zooms.",
            shortcut_label(Action::smaller_radius) + " and " +
                shortcut_label(Action::larger_radius) + " change the brush radius, " +
                shortcut_label(Action::toggle_symmetry) + " toggles symmetry, " +
                shortcut_label(Action::undo) + " undoes a drag."};
}

}  // namespace

void Panels::draw(Editor& editor, const PictureFigures& figures) {
    const bool had_dialog = editor.has_dialog();
    areas_.clear();
    draw_selection(editor);
    draw_hint(editor);  // first, so that the panels cover it in a small window
    draw_menus(editor);
    draw_status(editor, figures);
    draw_tools(editor);
    draw_settings(editor);
    draw_message(editor);
    draw_example(editor);
    help_.draw(editor, scale_);
    draw_question(editor);
    draw_recovery_question(editor.document());
    draw_file_panel(editor.document(), scale_);
    draw_progress_panel(editor, scale_);
    // A dialog that was closed in this frame claims no input, though Dear ImGui still counts it.
    has_popup_ = editor.has_dialog() ||
                 (!had_dialog && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId |
                                                            ImGuiPopupFlags_AnyPopupLevel));
    has_text_field_ = !had_dialog && ImGui::IsAnyItemActive() && ImGui::GetIO().WantTextInput;
}

UiClaims Panels::claims(const Vec2& at) const {
    const bool is_inside = std::any_of(areas_.begin(), areas_.end(), [&at](const Area& area) {
        return area.min.x <= at.x && at.x < area.max.x && area.min.y <= at.y && at.y < area.max.y;
    });
    return {.mouse = has_popup_ || is_inside, .keyboard = has_popup_ || has_text_field_};
}

void Panels::claim_window() {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    areas_.push_back({{at.x, at.y}, {at.x + size.x, at.y + size.y}});
}

void Panels::draw_menus(Editor& editor) {
    if (!ImGui::BeginMainMenuBar()) return;
    menu_height_ = ImGui::GetWindowSize().y;
    claim_window();
    menus_.draw(editor);
    ImGui::EndMainMenuBar();
}

void Panels::draw_tools(Editor& editor) {
    const float top = menu_height_ + scaled(kMargin);
    ImGui::SetNextWindowPos(ImVec2(scaled(kMargin), top));
    ImGui::Begin("tools", nullptr, kBare | ImGuiWindowFlags_AlwaysAutoResize);
    claim_window();
    const float below = status_height_ + scaled(kMargin) + 2.0f * ImGui::GetStyle().WindowPadding.y;
    tools_.draw(editor, scale_, ImGui::GetIO().DisplaySize.y - top - below);
    ImGui::End();
}

void Panels::draw_settings(Editor& editor) {
    const float width = scaled(kSettingsWidth), top = menu_height_ + scaled(kMargin);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(display.x - width - scaled(kMargin), top));
    ImGui::SetNextWindowSizeConstraints(
        ImVec2(width, 0.0f),
        ImVec2(width, std::max(scaled(80.0f), display.y - top - status_height_ - scaled(kMargin))));
    const bool is_open =
        ImGui::Begin("Settings", nullptr, kFixed | ImGuiWindowFlags_AlwaysAutoResize);
    claim_window();
    if (is_open) {
        if (ImGui::CollapsingHeader("Refine", ImGuiTreeNodeFlags_DefaultOpen)) refine_.draw(editor);
        if (editor.shown_settings().cage &&
            ImGui::CollapsingHeader("Lattice", ImGuiTreeNodeFlags_DefaultOpen)) {
            cage_.draw(editor, scale_);
        }
        if (ImGui::CollapsingHeader("Display", ImGuiTreeNodeFlags_DefaultOpen)) {
            draw_display_settings(editor);
        }
    }
    ImGui::End();
}

void Panels::draw_display_settings(Editor& editor) {
    action_checkbox(editor, Action::toggle_wireframe);
    action_checkbox(editor, Action::toggle_levels);
    action_checkbox(editor, Action::toggle_lattice);
    action_checkbox(editor, Action::toggle_symmetry_plane);
}

void Panels::draw_status(const Editor& editor, const PictureFigures& figures) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    status_height_ = ImGui::GetFrameHeight() + scaled(4.0f);
    ImGui::SetNextWindowPos(ImVec2(0.0f, display.y - status_height_));
    ImGui::SetNextWindowSize(ImVec2(display.x, status_height_));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(14.0f), scaled(6.0f)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("status", nullptr, kBare);
    claim_window();
    const FrameFigures frame = editor.figures();
    const ObjectFigures object = editor.workspace().object_figures();
    ImGui::TextUnformatted(counted(object.faces, "triangle", "triangles").c_str());
    ImGui::SameLine(scaled(180.0f));
    ImGui::Text("+%s  −%s", grouped(frame.splits).c_str(), grouped(frame.unsplits).c_str());
    if (ImGui::IsItemHovered()) {
        begin_status_tooltip("Splits and removals of the last frame");
        ImGui::EndTooltip();
    }
    ImGui::SameLine(scaled(320.0f));
    ImGui::Text("%.1f ms", 1e3 * frame.seconds);
    if (ImGui::IsItemHovered()) draw_frame_tooltip(frame, figures);
    ImGui::SameLine(scaled(420.0f));
    ImGui::Text("%.0f MB", 1e-6 * static_cast<double>(figures.memory_bytes));
    if (ImGui::IsItemHovered()) draw_memory_tooltip(object, figures);
    draw_status_text(editor, draw_drag_figures(editor));
    ImGui::End();
    ImGui::PopStyleVar(3);
}

// Draws on the right of the status line what was just confirmed, or else what the mouse does here.
// A text that does not fit beside the figures, which end at `left`, is left out; draw_message()
// shows the confirmation then.
void Panels::draw_status_text(const Editor& editor, float left) {
    const bool is_confirmation = editor.workspace().message_is_confirmation();
    const std::string text =
        is_confirmation ? editor.workspace().message() : std::string(editor.status_hint());
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float begin =
        ImGui::GetIO().DisplaySize.x - width - ImGui::GetStyle().WindowPadding.x - scaled(2.0f);
    const bool fits = !text.empty() && text.find('\n') == text.npos && begin >= left;
    status_confirms_ = is_confirmation && fits;
    if (!fits) return;
    ImGui::SameLine(begin);
    const ImGuiCol colour = is_confirmation ? ImGuiCol_Text : ImGuiCol_TextDisabled;
    ImGui::TextColored(ImGui::GetStyleColorVec4(colour), "%s", text.c_str());
}

// Begins a tooltip above the status bar, so that the bar stays visible.
void Panels::begin_status_tooltip(const char* title) const {
    const float left = ImGui::GetItemRectMin().x - ImGui::GetStyle().WindowPadding.x;
    const float bottom = ImGui::GetIO().DisplaySize.y - status_height_ - scaled(4.0f);
    ImGui::SetNextWindowPos(ImVec2(left, bottom), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(title);
}

void Panels::tooltip_row(const char* what, const std::string& figure) const {
    ImGui::TextDisabled("%s", what);
    ImGui::SameLine(scaled(90.0f));
    ImGui::TextUnformatted(figure.c_str());
}

void Panels::draw_frame_tooltip(const FrameFigures& frame, const PictureFigures& figures) const {
    begin_status_tooltip("Last frame of a drag");
    tooltip_row("deforming", formatted("%.1f ms", 1e3 * frame.deform_seconds));
    tooltip_row("refining", formatted("%.1f ms", 1e3 * frame.refine_seconds));
    tooltip_row("decimating", formatted("%.1f ms", 1e3 * frame.decimate_seconds));
    tooltip_row("uploaded", counted(figures.uploaded_bytes, "byte", "bytes") + " in " +
                                counted(figures.uploaded_ranges, "piece", "pieces"));
    ImGui::EndTooltip();
}

void Panels::draw_memory_tooltip(const ObjectFigures& object, const PictureFigures& figures) const {
    begin_status_tooltip("Memory");
    tooltip_row("program", megabytes(figures.memory_bytes));
    tooltip_row("undo", undo_memory(object));
    tooltip_row("steps", grouped(object.undo_steps) + " to undo, " + grouped(object.redo_steps) +
                             " to redo");
    if (object.lost_undo_steps > 0) {
        tooltip_row("dropped", grouped(object.lost_undo_steps) + " older");
    }
    ImGui::EndTooltip();
}

// Draws those figures of the drag that are worth showing, one beside the other. Returns where the
// next would begin.
float Panels::draw_drag_figures(const Editor& editor) const {
    const FrameFigures frame = editor.figures();
    float left = scaled(520.0f);
    const auto add_text = [&](const std::string& text, const ImVec4& colour) {
        ImGui::SameLine(left);
        ImGui::TextColored(colour, "%s", text.c_str());
        left += ImGui::CalcTextSize(text.c_str()).x + scaled(24.0f);
    };
    const ImVec4 plain = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    if (frame.steps > 1) add_text(std::to_string(frame.steps) + " steps", plain);
    if (frame.degrees != 0.0) add_text(formatted("twist %.0f°", frame.degrees), plain);
    if (frame.scale != 1.0) add_text(formatted("scale %.2f", frame.scale), plain);
    if (frame.folded > 0) {
        add_text(counted(frame.folded, "vertex folded", "vertices folded"), kWarning);
    }
    if (frame.budget_hit) {
        add_text("the triangle budget is used up", kWarning);
    } else if (frame.drag_budget_hit) {
        add_text("the triangle budget of a drag is used up", kWarning);
    }
    if (frame.floor_hit && !frame.budget_hit) {
        add_text("edges have reached the least length", kWarning);
    }
    return left;
}

// Draws the box with which a tool is selecting.
void Panels::draw_selection(const Editor& editor) const {
    const std::optional<ScreenBox> box = editor.selection_box();
    if (!box) return;
    const auto at = [](const Vec2& v) {
        return ImVec2(static_cast<float>(v.x), static_cast<float>(v.y));
    };
    const Vec2 low = glm::min(box->from, box->to), high = glm::max(box->from, box->to);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(at(low), at(high), IM_COL32(255, 190, 90, 28));
    list.AddRect(at(low), at(high), IM_COL32(255, 190, 90, 210), 0.0f, 0, scaled(1.2f));
}

void Panels::draw_message(Editor& editor) {
    const std::string message = editor.workspace().message();
    if (message.empty() || status_confirms_) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float close = ImGui::GetFrameHeight();
    // The message is between the panels. In a narrow window it covers them.
    const float frame = close + scaled(kMessageGap) + 2.0f * ImGui::GetStyle().WindowPadding.x;
    const float between_panels = display.x - 2.0f * scaled(kSettingsWidth + 2.0f * kMargin) - frame;
    const float longest = std::max(between_panels, 0.4f * display.x);
    const float text = std::min(longest, ImGui::CalcTextSize(message.c_str()).x + scaled(2.0f));
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, menu_height_ + scaled(kMargin)),
                            ImGuiCond_Always, ImVec2(0.5f, 0.0f));
    ImGui::PushStyleColor(ImGuiCol_Border, editor.workspace().message_is_confirmation()
                                               ? ImGui::GetStyleColorVec4(ImGuiCol_Border)
                                               : kWarningBorder);
    ImGui::Begin("message", nullptr, kBare | ImGuiWindowFlags_AlwaysAutoResize);
    claim_window();
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::PushTextWrapPos(left + text);
    ImGui::TextUnformatted(message.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(left + text + scaled(kMessageGap));
    if (ImGui::Button("×", ImVec2(close, close))) editor.workspace().dismiss();
    ImGui::End();
    ImGui::PopStyleColor();
}

void Panels::draw_hint(const Editor& editor) {
    if (!editor.shows_hint()) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, display.y - status_height_ - scaled(kMargin)),
                            ImGuiCond_Always, ImVec2(0.5f, 1.0f));
    ImGui::SetNextWindowBgAlpha(0.72f);
    ImGui::Begin("hint", nullptr,
                 kBare | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    for (const std::string& line : hint_lines()) ImGui::TextUnformatted(line.c_str());
    ImGui::End();
}

void Panels::draw_example(Editor& editor) {
    const float bottom = ImGui::GetIO().DisplaySize.y - status_height_ - scaled(kMargin);
    if (!begin_example_panel(editor, bottom, scale_)) return;
    claim_window();
    draw_example_panel(editor.example());
    ImGui::End();
}

void Panels::draw_question(Editor& editor) {
    using Answer = DocumentController::Answer;
    DocumentController& document = editor.document();
    const bool is_wanted = document.question() != nullptr;
    if (!begin_dialog(is_wanted, "Save the changes?", scaled(440.0f), 0.0f)) return;
    ImGui::TextWrapped("%s has unsaved changes.", editor.workspace().object_name().c_str());
    ImGui::Spacing();
    const ImVec2 size(scaled(120.0f), 0.0f);
    std::optional<Answer> answer;
    if (ImGui::Button("Save", size) || document.take_enter()) answer = Answer::save;
    ImGui::SameLine();
    if (ImGui::Button("Don't save", size)) answer = Answer::discard;
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size)) answer = Answer::cancel;
    ImGui::EndPopup();
    if (answer) document.answer(*answer);
}

void Panels::draw_recovery_question(DocumentController& document) {
    using Answer = DocumentController::RecoveryAnswer;
    const LostSession* const session = document.offered_session();
    if (!begin_dialog(session != nullptr, "Restore the last session?", scaled(460.0f), 0.0f)) {
        return;
    }
    ImGui::TextWrapped("pectin ended unexpectedly, with unsaved changes to \"%s\".",
                       session->object.c_str());
    ImGui::Spacing();
    const ImVec2 size(scaled(120.0f), 0.0f);
    std::optional<Answer> answer;
    if (ImGui::Button("Restore", size) || document.take_enter()) answer = Answer::restore;
    ImGui::SameLine();
    if (ImGui::Button("Discard", size)) answer = Answer::discard;
    ImGui::SameLine();
    if (ImGui::Button("Later", size)) answer = Answer::later;
    ImGui::EndPopup();
    if (answer) document.answer_recovery(*answer);
}

}  // namespace pectin

#include "app/panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/file_panel.h"
#include "app/progress_panel.h"

namespace pectin {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
constexpr ImGuiWindowFlags kBare = kFixed | ImGuiWindowFlags_NoTitleBar |
                                   ImGuiWindowFlags_NoScrollbar |
                                   ImGuiWindowFlags_NoFocusOnAppearing;
constexpr float kMargin = 12.0f;  // between panels and the window's edge
constexpr float kSettingsWidth = 310.0f;

constexpr float kMessageGap = 12.0f;  // between a message and the button that takes it away

constexpr std::array kHint{
    "Drag a point of the surface: what is round it follows.",
    "Drag beside the object to turn it, with Shift to move it; the wheel zooms.",
    "[ and ] set how far a drag reaches; Ctrl+Z takes it back.",
};

void item(Editor& editor, const char* label, Action action, bool enabled = true) {
    if (ImGui::MenuItem(label, shortcut_label(action).c_str(), false, enabled)) {
        editor.perform(action);
    }
}

void toggle(Editor& editor, const char* label, Action action, bool is_on) {
    if (ImGui::MenuItem(label, shortcut_label(action).c_str(), is_on)) editor.perform(action);
}

void draw_new_menu(Editor& editor) {
    using Kind = command::Shape::Kind;
    if (!ImGui::BeginMenu("New")) return;
    if (ImGui::MenuItem("Sphere")) editor.new_shape(Kind::sphere, 4);
    if (ImGui::MenuItem("Cube")) editor.new_shape(Kind::cube, 16);
    if (ImGui::MenuItem("Plane")) editor.new_shape(Kind::plane, 32);
    if (ImGui::MenuItem("Torus")) editor.new_shape(Kind::torus, 16);
    if (ImGui::MenuItem("Cylinder")) editor.new_shape(Kind::cylinder, 12);
    ImGui::EndMenu();
}

// 1234567 as 1,234,567.
std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
    return digits;
}

}  // namespace

void Panels::draw(Editor& editor, const PictureFigures& figures) {
    const bool had_dialog = editor.has_dialog();
    areas_.clear();
    draw_hint(editor);  // first, so that in a small window the panels lie over it
    draw_menus(editor);
    draw_status(editor, figures);
    draw_radius(editor);
    draw_settings(editor);
    draw_message(editor);
    draw_question(editor);
    draw_file_panel(editor, scale_);
    draw_progress_panel(editor, scale_);
    // A dialog that has just been closed claims nothing more, though Dear ImGui knows it yet.
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
    if (ImGui::BeginMenu("File")) {
        draw_new_menu(editor);
        item(editor, "Open…", Action::open);
        ImGui::Separator();
        item(editor, "Save", Action::save);
        item(editor, "Save as…", Action::save_as);
        item(editor, "Export OBJ…", Action::export_obj);
        item(editor, "Save a picture…", Action::save_picture);
        ImGui::Separator();
        item(editor, "Quit", Action::quit);
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Edit")) {
        item(editor, "Undo", Action::undo, editor.session().undo_count() > 0);
        item(editor, "Redo", Action::redo, editor.session().redo_count() > 0);
        ImGui::Separator();
        const TriMesh& mesh = editor.session().mesh();
        const bool is_refined = mesh.vertex_count() > mesh.base_vertex_count();
        if (ImGui::MenuItem("Bake refinement", nullptr, false, is_refined)) {
            editor.execute(command::Bake{});
        }
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("View")) {
        item(editor, "Frame all", Action::frame_all);
        item(editor, "Front", Action::view_front);
        item(editor, "Right", Action::view_right);
        item(editor, "Top", Action::view_top);
        ImGui::Separator();
        toggle(editor, "Wireframe", Action::toggle_wireframe, editor.display.wireframe);
        toggle(editor, "Lattice", Action::toggle_lattice, editor.display.lattice);
        toggle(editor, "Levels", Action::toggle_levels, editor.display.levels);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

void Panels::draw_radius(Editor& editor) {
    ImGui::SetNextWindowPos(ImVec2(scaled(kMargin), menu_height_ + scaled(kMargin)));
    ImGui::Begin("radius", nullptr, kBare | ImGuiWindowFlags_AlwaysAutoResize);
    claim_window();
    const float width = ImGui::CalcTextSize("Radius").x;
    ImGui::TextUnformatted("Radius");
    float radius = edited_radius_.value_or(static_cast<float>(editor.radius()));
    const float slider = scaled(24.0f);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5f * (width - slider));
    ImGui::VSliderFloat("##radius", ImVec2(slider, scaled(170.0f)), &radius,
                        static_cast<float>(editor.least_radius()),
                        static_cast<float>(editor.most_radius()), "",
                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("How far a drag reaches. [ and ] step it;\nhold F and move the mouse.");
    }
    if (ImGui::IsItemActive()) edited_radius_ = radius;
    if (ImGui::IsItemDeactivatedAfterEdit()) editor.set_radius(radius);
    if (!ImGui::IsItemActive()) edited_radius_.reset();
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", static_cast<double>(radius));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                         0.5f * (width - ImGui::CalcTextSize(text.data()).x));
    ImGui::TextUnformatted(text.data());
    ImGui::End();
}

void Panels::draw_settings(Editor& editor) {
    const float width = scaled(kSettingsWidth), top = menu_height_ + scaled(kMargin);
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(room.x - width - scaled(kMargin), top));
    ImGui::SetNextWindowSizeConstraints(
        ImVec2(width, 0.0f),
        ImVec2(width, std::max(scaled(80.0f), room.y - top - status_height_ - scaled(kMargin))));
    const bool is_open =
        ImGui::Begin("Settings", nullptr, kFixed | ImGuiWindowFlags_AlwaysAutoResize);
    claim_window();
    if (is_open) {
        if (ImGui::CollapsingHeader("Refine", ImGuiTreeNodeFlags_DefaultOpen)) refine_.draw(editor);
        if (ImGui::CollapsingHeader("Lattice", ImGuiTreeNodeFlags_DefaultOpen)) {
            draw_lattice_settings(editor);
        }
        if (ImGui::CollapsingHeader("Display", ImGuiTreeNodeFlags_DefaultOpen)) {
            draw_display_settings(editor);
        }
    }
    ImGui::End();
}

void Panels::draw_lattice_settings(Editor& editor) {
    const LatticeSettings& settings = editor.session().lattice_settings();
    const bool is_cage = settings.cage.has_value();
    if (ImGui::RadioButton("Brush", !is_cage) && is_cage) {
        editor.set_radius(editor.radius());
    }
    ImGui::SameLine(0.0f, scaled(22.0f));
    if (ImGui::RadioButton("Cage", is_cage) && !is_cage) {
        editor.execute(command::Cage{command::Cage::Fit{cage_counts_}});
    }
    if (!is_cage) {
        float span = edited_span_.value_or(static_cast<float>(settings.span));
        int points = static_cast<int>(span);
        ImGui::SetNextItemWidth(-scaled(112.0f));
        ImGui::SliderInt("control points##span", &points, 1, 9, "%d", ImGuiSliderFlags_AlwaysClamp);
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip(
                "Along each axis of the brush's lattice: more of them\n"
                "make a drag broader and its edge steeper.");
        }
        if (ImGui::IsItemActive()) edited_span_ = static_cast<float>(points);
        if (ImGui::IsItemDeactivatedAfterEdit()) editor.execute(command::Brush{.span = points});
        if (!ImGui::IsItemActive()) edited_span_.reset();
        return;
    }
    ImGui::SetNextItemWidth(-scaled(112.0f));
    ImGui::SliderInt3("control points##cage", &cage_counts_.x, 2, 12, "%d",
                      ImGuiSliderFlags_AlwaysClamp);
    const bool is_set = ImGui::IsItemDeactivatedAfterEdit();
    if (ImGui::Button("Fit to the object") || is_set) {
        editor.execute(command::Cage{command::Cage::Fit{cage_counts_}});
    }
}

void Panels::draw_display_settings(Editor& editor) {
    ImGui::Checkbox("Wireframe", &editor.display.wireframe);
    ImGui::Checkbox("Refinement levels", &editor.display.levels);
    ImGui::Checkbox("Lattice between drags", &editor.display.lattice);
}

void Panels::draw_status(const Editor& editor, const PictureFigures& figures) {
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    status_height_ = ImGui::GetFrameHeight() + scaled(4.0f);
    ImGui::SetNextWindowPos(ImVec2(0.0f, room.y - status_height_));
    ImGui::SetNextWindowSize(ImVec2(room.x, status_height_));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(14.0f), scaled(6.0f)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("status", nullptr, kBare);
    claim_window();
    const FrameFigures& frame = editor.figures();
    ImGui::Text("%s triangles", grouped(editor.session().mesh().face_count()).c_str());
    ImGui::SameLine(scaled(180.0f));
    ImGui::Text("+%s  −%s", grouped(frame.splits).c_str(), grouped(frame.unsplits).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Splits and removals of the last frame");
    ImGui::SameLine(scaled(320.0f));
    ImGui::Text("%.1f ms", 1e3 * frame.seconds);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip(
            "Of the last frame of a drag\n  moving   %.1f ms\n  refining %.1f ms\n"
            "  thinning %.1f ms\n%s bytes uploaded in %s pieces",
            1e3 * frame.deform_seconds, 1e3 * frame.refine_seconds, 1e3 * frame.decimate_seconds,
            grouped(figures.uploaded_bytes).c_str(), grouped(figures.uploaded_ranges).c_str());
    }
    ImGui::SameLine(scaled(420.0f));
    ImGui::Text("%.0f MB", 1e-6 * static_cast<double>(figures.memory_bytes));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Memory that the program uses");
    if (frame.budget_hit || frame.floor_hit) {
        ImGui::SameLine(scaled(520.0f));
        ImGui::TextColored(ImVec4(0.93f, 0.74f, 0.45f, 1.0f), "%s",
                           frame.budget_hit ? "the triangle budget is used up"
                                            : "edges are as short as they may be");
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

void Panels::draw_message(Editor& editor) {
    const std::string& message = editor.workspace().message();
    if (message.empty()) return;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float close = ImGui::GetFrameHeight();
    // Between the panels, in the middle of the window; over them where that is too narrow.
    const float frame = close + scaled(kMessageGap) + 2.0f * ImGui::GetStyle().WindowPadding.x;
    const float beside = room.x - 2.0f * scaled(kSettingsWidth + 2.0f * kMargin) - frame;
    const float most = std::max(beside, 0.4f * room.x);
    const float text = std::min(most, ImGui::CalcTextSize(message.c_str()).x + scaled(2.0f));
    ImGui::SetNextWindowPos(ImVec2(0.5f * room.x, menu_height_ + scaled(kMargin)), ImGuiCond_Always,
                            ImVec2(0.5f, 0.0f));
    ImGui::PushStyleColor(ImGuiCol_Border, ImVec4(0.86f, 0.62f, 0.34f, 0.8f));
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
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * room.x, room.y - status_height_ - scaled(kMargin)),
                            ImGuiCond_Always, ImVec2(0.5f, 1.0f));
    ImGui::SetNextWindowBgAlpha(0.72f);
    ImGui::Begin("hint", nullptr,
                 kBare | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    for (const char* line : kHint) ImGui::TextUnformatted(line);
    ImGui::End();
}

void Panels::draw_question(Editor& editor) {
    if (!begin_dialog(editor.question.has_value(), "Save the changes?", scaled(440.0f), 0.0f)) {
        return;
    }
    ImGui::TextWrapped("%s has changes that are not saved.",
                       editor.workspace().object_name().c_str());
    ImGui::Spacing();
    const ImVec2 size(scaled(120.0f), 0.0f);
    std::optional<Editor::Answer> answer;
    if (ImGui::Button("Save", size) || editor.take_enter()) answer = Editor::Answer::save;
    ImGui::SameLine();
    if (ImGui::Button("Don't save", size)) answer = Editor::Answer::discard;
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size)) answer = Editor::Answer::cancel;
    ImGui::EndPopup();
    if (answer) editor.answer(*answer);
}

}  // namespace pectin

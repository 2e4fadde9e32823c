#include "app/ui/panels.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/ui/action_widgets.h"
#include "app/ui/axes_view.h"
#include "app/ui/example_panel.h"
#include "app/ui/file_panel.h"
#include "app/ui/progress_panel.h"
#include "app/ui/questions.h"
#include "app/ui/theme.h"
#include "app/ui/tool_strip.h"

namespace pectin {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoFocusOnAppearing;
constexpr ImGuiWindowFlags kBare = kFixed | ImGuiWindowFlags_NoScrollbar;

constexpr float kMargin = 12.0f;  // between a message or a hint and what is beside it
constexpr float kSideWidth = 312.0f;
constexpr float kMostSideWidth = 0.5f;  // of the window
constexpr float kStripPadding = 5.0f;
constexpr float kMessageGap = 12.0f;  // between a message and its close button
constexpr float kLeastMessageWidth = 220.0f;
constexpr float kHintOpacity = 0.8f;
constexpr float kLeastHintWidth = 18.0f;  // in heights of the font

std::array<std::string, 3> hint_lines() {
    return {"Drag the surface to pull it; the area around it follows.",
            "Drag the background to rotate the view, Shift+drag to pan; wheel to zoom.",
            shortcut_label(Action::smaller_radius) + " and " +
                shortcut_label(Action::larger_radius) + " change the radius, " +
                shortcut_label(Action::toggle_symmetry) + " switches symmetry, " +
                shortcut_label(Action::undo) + " takes a drag back."};
}

ImVec2 to_imgui(const Vec2& v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

// Places the next window at the border of the free area and lets its edges be straight.
void begin_docked(const char* name, const ImVec2& at, const ImVec2& size, const ImVec2& padding,
                  ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin(name, nullptr, flags);
    ImGui::PopStyleVar(4);
}

}  // namespace

void Panels::draw(Editor& editor, const PictureFigures& figures, float scale) {
    const bool had_dialog = editor.has_dialog();
    scale_ = scale;
    areas_.clear();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    free_ = {{0.0, 0.0}, {display.x, display.y}};
    close_menu_if_wanted(editor);
    draw_selection(editor);
    draw_menus(editor);
    draw_status(editor, figures);
    if (!editor.preferences.hides_panels) {
        draw_strip(editor);
        draw_side(editor);
    }
    side_.update_preview(editor);
    draw_hint(editor);
    draw_message(editor);
    draw_example(editor);
    help_.draw(editor, scale);
    draw_questions(editor, scale);
    draw_file_panel(editor.document(), scale);
    draw_progress_panel(editor, scale);
    editor.set_free_area({free_.min, free_.max}, static_cast<double>(scale));
    draw_axes(editor, scale);
    // The control that was setting the radius may not be shown any more.
    if (!ImGui::IsAnyItemActive()) editor.radius_preview.reset();
    // A dialog that was closed in this frame claims no input, though Dear ImGui still counts it.
    has_popup_ = editor.has_dialog() ||
                 (!had_dialog && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId |
                                                            ImGuiPopupFlags_AnyPopupLevel));
    has_menu_ = has_popup_ && !editor.has_dialog();
    has_text_field_ = !had_dialog && ImGui::IsAnyItemActive() && ImGui::GetIO().WantTextInput;
}

UiClaims Panels::claims(const Vec2& at) const {
    const bool is_inside = std::any_of(areas_.begin(), areas_.end(), [&at](const Area& area) {
        return area.min.x <= at.x && at.x < area.max.x && area.min.y <= at.y && at.y < area.max.y;
    });
    return {.mouse = has_popup_ || is_inside, .keyboard = has_popup_ || has_text_field_};
}

bool Panels::take_key(Key key) {
    if (key != Key::escape || !has_menu_) return menus_.take_key(key);
    closes_menu_ = true;
    return true;
}

// Closes the open menu with its submenus, or the open list. Only closing a submenu would be no use,
// since the cursor over its entry opens it again.
void Panels::close_menu_if_wanted(const Editor& editor) {
    const bool is_open = !ImGui::GetCurrentContext()->OpenPopupStack.empty();
    if (std::exchange(closes_menu_, false) && is_open && !editor.has_dialog()) {
        ImGui::ClosePopupToLevel(0, true);
    }
}

void Panels::claim_window() {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    areas_.push_back({{at.x, at.y}, {at.x + size.x, at.y + size.y}});
}

void Panels::draw_menus(Editor& editor) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    const bool is_open = ImGui::BeginMainMenuBar();
    ImGui::PopStyleVar();
    if (!is_open) return;
    free_.min.y = ImGui::GetWindowSize().y;
    claim_window();
    menus_.draw(editor);
    ImGui::EndMainMenuBar();
}

void Panels::draw_status(const Editor& editor, const PictureFigures& figures) {
    const float height = ImGui::GetFrameHeight() + scaled(4.0f);
    free_.max.y -= height;
    const auto width = static_cast<float>(free_.max.x);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    begin_docked("status", ImVec2(0.0f, static_cast<float>(free_.max.y)), ImVec2(width, height),
                 ImVec2(scaled(12.0f), scaled(2.0f)), kBare);
    claim_window();
    status_.draw(editor, figures, scale_);
    ImGui::End();
    ImGui::PopStyleColor();
}

void Panels::draw_strip(Editor& editor) {
    const float padding = scaled(kStripPadding);
    const auto height = static_cast<float>(free_.max.y - free_.min.y);
    const float button = tool_button_size(height - 2.0f * padding, scale_);
    const float width = button + 2.0f * padding;
    begin_docked("tools", to_imgui(free_.min), ImVec2(width, height), ImVec2(padding, padding),
                 kBare);
    claim_window();
    draw_tool_strip(editor, button);
    ImGui::End();
    free_.min.x += width;
}

void Panels::draw_side(Editor& editor) {
    const auto display = static_cast<float>(free_.max.x);
    const float width = std::min(scaled(kSideWidth), kMostSideWidth * display);
    const auto height = static_cast<float>(free_.max.y - free_.min.y);
    begin_docked("settings", ImVec2(display - width, static_cast<float>(free_.min.y)),
                 ImVec2(width, height), ImVec2(scaled(10.0f), scaled(8.0f)), kFixed);
    claim_window();
    side_.draw(editor);
    ImGui::End();
    free_.max.x -= width;
}

// Draws the box with which a tool is selecting.
void Panels::draw_selection(const Editor& editor) const {
    const std::optional<ScreenBox> box = editor.selection_box();
    if (!box) return;
    const Vec2 low = glm::min(box->from, box->to), high = glm::max(box->from, box->to);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    ImVec4 colour = theme_colour(ThemeColour::selection);
    list.AddRect(to_imgui(low), to_imgui(high), ImGui::GetColorU32(colour), 0.0f, 0, scaled(1.2f));
    colour.w = 0.12f;
    list.AddRectFilled(to_imgui(low), to_imgui(high), ImGui::GetColorU32(colour));
}

// Where a message may be: at the top of the free area, to the left of the axes, or below them where
// that is too narrow.
Panels::Area Panels::message_space(const Editor& editor) const {
    const auto margin = static_cast<double>(scaled(kMargin));
    Area space{free_.min + margin, free_.max - margin};
    const std::optional<AxesGizmo> axes = editor.view_control().axes();
    if (!axes) return space;
    const double left = axes->centre.x - axes->radius - margin;
    if (left - space.min.x >= static_cast<double>(scaled(kLeastMessageWidth))) {
        space.max.x = left;
    } else {
        space.min.y = axes->centre.y + axes->radius + margin;
    }
    return space;
}

void Panels::draw_message(Editor& editor) {
    const Workspace& workspace = editor.workspace();
    const std::string message = workspace.message();
    if (message.empty() || status_.shows_message()) return;
    const float close = ImGui::GetFrameHeight();
    const float frame = close + scaled(kMessageGap) + 2.0f * ImGui::GetStyle().WindowPadding.x;
    const Area space = message_space(editor);
    const auto longest = static_cast<float>(space.max.x - space.min.x) - frame;
    const float text = std::min(longest, ImGui::CalcTextSize(message.c_str()).x + scaled(2.0f));
    // In the middle of the free area, if there is enough space on both sides.
    const double half = 0.5 * static_cast<double>(text + frame);
    const double middle = std::clamp(0.5 * (free_.min.x + free_.max.x), space.min.x + half,
                                     std::max(space.min.x + half, space.max.x - half));
    ImGui::SetNextWindowPos(to_imgui({middle, space.min.y}), ImGuiCond_Always, ImVec2(0.5f, 0.0f));
    ImGui::PushStyleColor(ImGuiCol_Border, workspace.message_warns()
                                               ? theme_colour(ThemeColour::warning_border)
                                               : ImGui::GetStyleColorVec4(ImGuiCol_Border));
    ImGui::Begin("message", nullptr, kBare | ImGuiWindowFlags_AlwaysAutoResize);
    claim_window();
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::PushTextWrapPos(left + text);
    ImGui::TextUnformatted(message.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(left + text + scaled(kMessageGap));
    if (ImGui::Button("×", ImVec2(close, close))) editor.workspace().dismiss();
    tooltip("×", "Close the message. (Esc)");
    ImGui::End();
    ImGui::PopStyleColor();
}

void Panels::draw_hint(const Editor& editor) const {
    if (!editor.shows_hint()) return;
    const auto lines = hint_lines();
    float width = 0.0f;
    for (const std::string& line : lines) {
        width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
    }
    const auto free_width = static_cast<float>(free_.max.x - free_.min.x);
    const float padding = 2.0f * (ImGui::GetStyle().WindowPadding.x + scaled(kMargin));
    const float wrap = std::min(width + scaled(2.0f), free_width - padding);
    // In a small window the hint would hide the object. The status line says the same.
    if (wrap < kLeastHintWidth * ImGui::GetFontSize()) return;
    const Vec2 at{0.5 * (free_.min.x + free_.max.x),
                  free_.max.y - static_cast<double>(scaled(kMargin))};
    ImGui::SetNextWindowPos(to_imgui(at), ImGuiCond_Always, ImVec2(0.5f, 1.0f));
    ImGui::SetNextWindowBgAlpha(kHintOpacity);
    ImGui::Begin("hint", nullptr,
                 kBare | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap);
    for (const std::string& line : lines) ImGui::TextUnformatted(line.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void Panels::draw_example(Editor& editor) {
    const Area space{free_.min + static_cast<double>(scaled(kMargin)),
                     free_.max - static_cast<double>(scaled(kMargin))};
    if (!begin_example_panel(editor, to_imgui(space.min), to_imgui(space.max), scale_)) return;
    claim_window();
    draw_example_panel(editor.example());
    free_.max.y = static_cast<double>(ImGui::GetWindowPos().y);
    ImGui::End();
}

}  // namespace pectin

#include "app/ui/tool_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/ui/action_widgets.h"

namespace pectin {
namespace {

constexpr float kWidth = 96.0f;
constexpr float kSliderHeight = 170.0f, kMinSliderHeight = 50.0f;
// The height of everything except the slider, in lines of buttons and of text.
constexpr float kButtonLines = 6.0f, kTextLines = 2.0f;

void draw_symmetry(Editor& editor, float width) {
    using Plane = command::Symmetry::Plane;
    const bool is_on = editor.session().symmetry().has_value();
    action_button(editor, Action::toggle_symmetry, width);
    MirrorChoice choice = editor.mirror_choice();
    constexpr std::array kPlanes{Plane::x, Plane::y, Plane::z};
    constexpr std::array kNames{"x", "y", "z"};
    const float gap = 0.5f * ImGui::GetStyle().ItemSpacing.x;
    const float third = (width - 2.0f * gap) / 3.0f;
    for (std::size_t i = 0; i < kPlanes.size(); ++i) {
        if (i > 0) ImGui::SameLine(0.0f, gap);
        const bool is_chosen = choice.plane == kPlanes[i];
        ImGui::BeginDisabled(!is_on);
        if (toggle_button(kNames[i], is_chosen && is_on, third)) {
            choice.plane = kPlanes[i];
            editor.choose_mirror(choice);
        }
        ImGui::EndDisabled();
        tooltip("The axis across the plane of symmetry.");
    }
    ImGui::BeginDisabled(!is_on);
    if (ImGui::Button(choice.through_centre ? "at middle" : "at origin", ImVec2(width, 0.0f))) {
        choice.through_centre = !choice.through_centre;
        editor.choose_mirror(choice);
    }
    ImGui::EndDisabled();
    tooltip(
        "The plane's position: at the origin, or in the middle of the object as it was opened.");
}

void draw_pins(Editor& editor, float width) {
    std::array<char, 32> label{};
    const std::size_t count = editor.pins().points().size();
    const char* const name = info_of(Action::toggle_pinning).name;
    std::snprintf(label.data(), label.size(), count > 0 ? "%s  (%zu)###pin" : "%s###pin", name,
                  count);
    action_button(editor, Action::toggle_pinning, width, label.data());
}

}  // namespace

void ToolPanel::draw(Editor& editor, float scale, float available) {
    const float width = kWidth * scale;
    const float others = kButtonLines * ImGui::GetFrameHeightWithSpacing() +
                         kTextLines * ImGui::GetTextLineHeightWithSpacing() +
                         4.0f * ImGui::GetStyle().ItemSpacing.y;
    const ShownSettings shown = editor.shown_settings();
    if (shown.radius) {
        draw_radius(
            editor, width,
            std::clamp(available - others, kMinSliderHeight * scale, kSliderHeight * scale));
        ImGui::Separator();
    }
    if (shown.mirror) {
        draw_symmetry(editor, width);
        ImGui::Separator();
    }
    if (shown.pins) draw_pins(editor, width);
    if (shown.connected) action_button(editor, Action::toggle_connected, width);
    if (shown.fold_free) action_button(editor, Action::toggle_fold_free, width);
}

void ToolPanel::draw_radius(Editor& editor, float width, float height) {
    const float left = ImGui::GetCursorPosX();
    const auto centre = [&](float text_width) {
        ImGui::SetCursorPosX(left + 0.5f * (width - text_width));
    };
    centre(ImGui::CalcTextSize("Radius").x);
    ImGui::TextUnformatted("Radius");
    float radius = edited_radius_.value_or(static_cast<float>(editor.radius()));
    const float slider = 0.25f * width;
    centre(slider);
    ImGui::VSliderFloat("##radius", ImVec2(slider, height), &radius,
                        static_cast<float>(editor.min_radius()),
                        static_cast<float>(editor.max_radius()), "",
                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    tooltip(("The radius of the brush. " + shortcut_label(Action::smaller_radius) + " and " +
             shortcut_label(Action::larger_radius) +
             " change it in steps. Or hold F and move the mouse.")
                .c_str());
    if (ImGui::IsItemActive()) edited_radius_ = radius;
    if (ImGui::IsItemDeactivatedAfterEdit()) editor.set_radius(static_cast<double>(radius));
    if (!ImGui::IsItemActive()) edited_radius_.reset();
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", static_cast<double>(radius));
    centre(ImGui::CalcTextSize(text.data()).x);
    ImGui::TextUnformatted(text.data());
}

}  // namespace pectin

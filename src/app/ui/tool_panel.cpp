#include "app/ui/tool_panel.h"

#include <imgui.h>

#include <array>
#include <cstdio>

#include "app/ui/action_widgets.h"
#include "app/ui/brush_section.h"

namespace pectin {
namespace {

constexpr float kWidth = 96.0f;

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

void ToolPanel::draw(Editor& editor, float scale) {
    const float width = kWidth * scale;
    const ShownSettings shown = editor.shown_settings();
    if (shown.radius) {
        draw_brush_section(editor, width, scale);
        ImGui::Separator();
    }
    if (shown.mirror) {
        draw_symmetry(editor, width);
        ImGui::Separator();
    }
    if (shown.pins) draw_pins(editor, width);
}

}  // namespace pectin

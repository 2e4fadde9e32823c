#include "app/ui/brush_panel.h"

#include <array>
#include <string>

#include "app/ui/action_widgets.h"
#include "app/ui/figure_text.h"
#include "app/ui/rows.h"
#include "command/limits.h"

namespace pectin {
namespace {

constexpr const char* kRadiusHelp = "How far from the point that you grab the surface follows.";
constexpr const char* kPointsHelp =
    "How many control points the brush has along each axis: with more of them the area that "
    "follows is narrower.";
constexpr const char* kPlaneHelp = "The axis across which drags are mirrored.";
constexpr const char* kThroughHelp =
    "Whether the plane of symmetry goes through the origin or through the middle of the object as "
    "it was opened.";

void draw_axes(Editor& editor) {
    using Plane = command::Symmetry::Plane;
    constexpr std::array kPlanes{Plane::x, Plane::y, Plane::z};
    constexpr std::array kNames{"X", "Y", "Z"};
    const bool is_on = editor.session().symmetry().has_value();
    MirrorChoice choice = editor.mirror_choice();
    begin_row("Mirrored axis");
    const float width = third_of_row();
    ImGui::BeginDisabled(!is_on);
    for (std::size_t i = 0; i < kPlanes.size(); ++i) {
        if (i > 0) ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
        if (toggle_button(kNames[i], is_on && choice.plane == kPlanes[i], width)) {
            choice.plane = kPlanes[i];
            editor.choose_mirror(choice);
        }
        tooltip(kNames[i], kPlaneHelp);
    }
    ImGui::EndDisabled();
}

void draw_through(Editor& editor) {
    MirrorChoice choice = editor.mirror_choice();
    begin_row("Plane through");
    ImGui::BeginDisabled(!editor.session().symmetry().has_value());
    int chosen = choice.through_centre ? 1 : 0;
    if (ImGui::Combo("##through", &chosen, "Origin\0Middle of the object\0")) {
        choice.through_centre = chosen == 1;
        editor.choose_mirror(choice);
    }
    ImGui::EndDisabled();
    tooltip("Plane through", kThroughHelp);
}

void draw_pins(Editor& editor) {
    const std::size_t count = editor.pins().points().size();
    if (count == 0) return;
    begin_row(counted(count, "pin", "pins").c_str());
    action_button(editor, Action::remove_pins, -1.0f);
}

}  // namespace

void BrushPanel::draw(Editor& editor) {
    const ShownSettings shown = editor.shown_settings();
    ImGui::BeginDisabled(editor.session().lattice_settings().cage.has_value());
    if (shown.radius) draw_radius(editor);
    draw_points(editor);
    ImGui::EndDisabled();
    if (shown.connected) action_checkbox(editor, Action::toggle_connected);
    if (shown.fold_free) action_checkbox(editor, Action::toggle_fold_free);
    if (shown.mirror) {
        action_checkbox(editor, Action::toggle_symmetry);
        draw_axes(editor);
        draw_through(editor);
    }
    if (shown.pins) draw_pins(editor);
}

void BrushPanel::draw_radius(Editor& editor) {
    begin_row("Radius");
    const NumberStyle style{
        .left = editor.min_radius(), .right = editor.max_radius(), .is_logarithmic = true};
    if (const auto radius = fields_.draw("##radius", editor.radius(), style)) {
        editor.execute(command::Brush{.radius = *radius});
    }
    tooltip("Radius", (std::string(kRadiusHelp) + " F and a move of the mouse, " +
                       shortcut_label(Action::smaller_radius) + " and " +
                       shortcut_label(Action::larger_radius) + " change it, too.")
                          .c_str());
}

void BrushPanel::draw_points(Editor& editor) {
    constexpr field::Limits kLimits = limits_of(&command::Brush::span);
    begin_row("Points per axis");
    const NumberStyle style{.format = "%.0f", .left = kLimits.least, .right = kLimits.most};
    const double span = editor.session().lattice_settings().span;
    if (const auto set = fields_.draw("##points", span, style)) {
        editor.execute(command::Brush{.span = whole_number(*set)});
    }
    tooltip("Points per axis", kPointsHelp);
}

}  // namespace pectin

#include "app/ui/brush_panel.h"

#include <algorithm>
#include <array>
#include <string>

#include "app/ui/action_widgets.h"
#include "app/ui/falloff_curve.h"
#include "app/ui/figure_text.h"
#include "app/ui/rows.h"
#include "command/check.h"
#include "command/limits.h"

namespace pectin {
namespace {

constexpr const char* kRadiusHelp = "How far from the point that you grab the surface follows.";
constexpr const char* kStrengthHelp =
    "How much of the cursor's way the point that you grab follows.";
constexpr const char* kPlaneHelp = "The axis across which drags are mirrored.";
constexpr const char* kThroughHelp =
    "Whether the plane of symmetry goes through the origin or through the middle of the object as "
    "it was opened.";

// What the radius is measured in, in the order of RadiusUnit.
struct UnitInfo {
    const char* name;
    const char* help;
    const char* format;
    const char* suffix;
    double factor;  // from the radius in its unit to the number on screen
};
constexpr std::array<UnitInfo, 3> kUnits{{
    {"Share of the object",
     "The radius is a share of the object's diagonal, and other objects get a radius that suits "
     "them.",
     "%.1f", " %", 100.0},
    {"Model units", "The radius is a length in the units of the model.", "%.3g", "", 1.0},
    {"On screen",
     "The radius has this many pixels where a drag begins, so that zooming in makes it smaller on "
     "the object.",
     "%.0f", " px", 1.0},
}};

void draw_unit(Editor& editor) {
    begin_row("Measured in");
    const auto present = static_cast<std::size_t>(editor.brush_size().unit);
    if (ImGui::BeginCombo("##unit", kUnits[present].name)) {
        for (std::size_t i = 0; i < kUnits.size(); ++i) {
            if (ImGui::Selectable(kUnits[i].name, i == present)) {
                editor.set_radius_unit(static_cast<RadiusUnit>(i));
            }
            tooltip(kUnits[i].name, kUnits[i].help);
        }
        ImGui::EndCombo();
    } else {
        tooltip("Measured in", kUnits[present].help);
    }
}

// A radius that is no length is refused like that of a script, but a share in its own unit.
void set_radius(Editor& editor, double value) {
    const auto& unit = kUnits[static_cast<std::size_t>(editor.brush_size().unit)];
    switch (editor.brush_size().unit) {
        case RadiusUnit::share: {
            const command::Brush brush{.radius = value * editor.workspace().diagonal()};
            if (check(brush)) {
                editor.execute(brush);
            } else {
                const std::string number = formatted("%.6g", unit.factor * value);
                editor.workspace().set_message("Radius must be above 0" + std::string(unit.suffix) +
                                               ", not " + number + unit.suffix + ".");
            }
            break;
        }
        case RadiusUnit::model:
            editor.execute(command::Brush{.radius = value});
            break;
        case RadiusUnit::screen:
            editor.set_radius_value(value);
            break;
    }
}

void draw_falloff(Editor& editor) {
    struct Info {
        Falloff falloff;
        const char* name;
        const char* help;
        int span;  // the number of control points that it begins with
    };
    constexpr std::array<Info, 2> kFalloffs{{
        {Falloff::sharp, "Sharp",
         "A drag pulls the surface to a peak at the point that you grab. It begins with 3 control "
         "points per axis.",
         3},
        {Falloff::plateau, "Plateau",
         "A drag moves the area around the point along with it and falls off towards the edge. It "
         "begins with 5 control points per axis, since fewer have no flat top.",
         5},
    }};
    begin_row("Falloff");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
    const Falloff present = editor.session().lattice_settings().falloff;
    for (const Info& info : kFalloffs) {
        if (info.falloff == Falloff::plateau) ImGui::SameLine(0.0f, gap);
        if (toggle_button(info.name, info.falloff == present, width) && info.falloff != present) {
            editor.execute(command::Brush{.span = info.span, .falloff = info.falloff});
        }
        tooltip(info.name, info.help);
    }
    draw_falloff_curve(editor.brush_profile());
}

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
    ImGui::BeginDisabled(editor.has_cage());
    if (shown.radius) {
        draw_radius(editor);
        draw_unit(editor);
        draw_falloff(editor);
    }
    draw_points(editor);
    draw_strength(editor);
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

// While the number is dragged, the object shows the radius.
void BrushPanel::draw_radius(Editor& editor) {
    begin_row("Radius");
    const auto& unit = kUnits[static_cast<std::size_t>(editor.brush_size().unit)];
    editor.radius_preview.reset();
    const Range range = editor.radius_range();
    const NumberStyle style{.format = unit.format,
                            .unit = unit.suffix,
                            .left = unit.factor * range.least,
                            .right = unit.factor * range.most,
                            .is_logarithmic = true};
    const auto set = fields_.draw("##radius", unit.factor * editor.radius_value(), style);
    if (const auto dragged = fields_.dragged()) editor.radius_preview = *dragged / unit.factor;
    if (set) set_radius(editor, *set / unit.factor);
    std::string help = kRadiusHelp;
    help += " F and a move of the mouse, " + shortcut_label(Action::smaller_radius) + " and " +
            shortcut_label(Action::larger_radius) + " change it, too.";
    tooltip("Radius", help.c_str());
}

void BrushPanel::draw_points(Editor& editor) {
    constexpr field::Limits kLimits = limits_of(&command::Brush::span);
    begin_row("Points per axis");
    const NumberStyle style{.format = "%.0f", .left = kLimits.least, .right = kLimits.most};
    const double span = editor.session().lattice_settings().span;
    if (const auto set = fields_.draw("##points", span, style)) {
        editor.execute(command::Brush{.span = whole_number(*set)});
    }
    const BrushProfile& profile = editor.brush_profile();
    const bool is_sharp = profile.falloff() == Falloff::sharp;
    const double half = profile.distance_at(0.5, Vec3{1.0, 0.0, 0.0});
    std::string help = "How many control points the brush has along each axis. More of them make ";
    help += is_sharp ? "a sharp drag narrower" : "a plateau wider";
    help += ": now the surface moves half as far as the point that you grab at ";
    help += formatted("%.3g", half) + " of the radius.";
    tooltip("Points per axis", help.c_str());
}

void BrushPanel::draw_strength(Editor& editor) {
    begin_row("Strength");
    const NumberStyle style{.format = "%.0f", .unit = " %", .left = 1.0, .right = 100.0};
    if (const auto set = fields_.draw("##strength", 100.0 * editor.drag_strength, style)) {
        editor.drag_strength = 0.01 * std::clamp(*set, style.left, style.right);
    }
    tooltip("Strength", kStrengthHelp);
}

}  // namespace pectin

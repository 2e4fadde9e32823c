#include "app/ui/brush_section.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "app/ui/action_widgets.h"

namespace pectin {
namespace {

constexpr int kMaxSpan = 9;
constexpr float kCurveHeight = 64.0f;
constexpr int kCurvePoints = 64;
// Narrower sections have the words for units and falloffs below each other.
constexpr float kNarrow = 180.0f;
constexpr Vec3 kAlongAxis{1.0, 0.0, 0.0};
const Vec3 kAlongDiagonal = glm::normalize(Vec3{1.0, 1.0, 0.0});

std::string rounded(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

// --- Radius

struct UnitInfo {
    RadiusUnit unit;
    const char* name;
    const char* tooltip;
    const char* format;
    double factor;  // from the radius in its unit to the number on screen
};
constexpr std::array<UnitInfo, 3> kUnits{{
    {RadiusUnit::share, "of the object",
     "The radius is a share of the object's diagonal, and other objects get a radius that fits "
     "them.",
     "%.1f %%", 100.0},
    {RadiusUnit::model, "in model units", "The radius is a length in the units of the model.",
     "%.4g", 1.0},
    {RadiusUnit::screen, "on screen",
     "The radius has this many pixels where a drag begins, so that zooming in makes it smaller on "
     "the object.",
     "%.0f px", 1.0},
}};

// held: the radius in its unit, while the slider is held.
void draw_radius(Editor& editor, float width, const std::optional<double>& held) {
    const auto& info = kUnits[static_cast<std::size_t>(editor.brush_size().unit)];
    const Range range = editor.radius_range();
    auto shown = static_cast<float>(info.factor * held.value_or(editor.radius_value()));
    ImGui::TextUnformatted("Radius");
    ImGui::SetNextItemWidth(width);
    ImGui::SliderFloat("##radius", &shown, static_cast<float>(info.factor * range.least),
                       static_cast<float>(info.factor * range.most), info.format,
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    const double value = static_cast<double>(shown) / info.factor;
    tooltip(("The radius of the brush. " + shortcut_label(Action::smaller_radius) + " and " +
             shortcut_label(Action::larger_radius) +
             " change it in steps, or hold F and move the mouse.")
                .c_str());
    if (ImGui::IsItemActive()) editor.radius_preview = value;
    if (ImGui::IsItemDeactivatedAfterEdit()) editor.set_radius_value(value);
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##unit", info.name)) {
        for (const UnitInfo& unit : kUnits) {
            if (ImGui::Selectable(unit.name, unit.unit == info.unit)) {
                editor.set_radius_unit(unit.unit);
            }
            tooltip(unit.tooltip);
        }
        ImGui::EndCombo();
    } else {
        tooltip(info.tooltip);
    }
}

// --- Falloff

// The curve of the weight along an axis of the lattice, from a radius on one side of the grabbed
// point to a radius on the other, with a line where it is half.
void draw_curve(const BrushProfile& profile, float width, float scale) {
    const ImVec2 size(width, kCurveHeight * scale), from = ImGui::GetCursorScreenPos();
    const ImVec2 to(from.x + size.x, from.y + size.y);
    ImGui::InvisibleButton("##curve", size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.5f);
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), 4.0f * scale);
    const float margin = 6.0f * scale;
    const float left = from.x + margin, right = to.x - margin;
    const float top = from.y + margin, bottom = to.y - margin;
    const auto at = [&](double distance, double weight) {
        return ImVec2(left + (right - left) * static_cast<float>(0.5 + 0.5 * distance),
                      bottom + (top - bottom) * static_cast<float>(weight));
    };
    const double half = profile.distance_at(0.5, kAlongAxis);
    list.AddLine(at(-1.0, 0.0), at(1.0, 0.0), faint, scale);
    list.AddLine(at(-half, 0.5), at(half, 0.5), faint, scale);
    for (const double side : {-half, half})
        list.AddLine(at(side, 0.0), at(side, 0.5), faint, scale);
    std::array<ImVec2, kCurvePoints + 1> points;
    for (int i = 0; i <= kCurvePoints; ++i) {
        const double distance = 2.0 * i / kCurvePoints - 1.0;
        points[static_cast<std::size_t>(i)] = at(distance, profile.weight(distance * kAlongAxis));
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()),
                     ImGui::GetColorU32(ImGuiCol_CheckMark), 0, 2.0f * scale);
    tooltip(("How far points move with the grabbed point, along an axis of the object. They move "
             "half as far at " +
             rounded(half) + " of the radius, and in the diagonal between two axes at " +
             rounded(profile.distance_at(0.5, kAlongDiagonal)) + ".")
                .c_str());
}

void draw_falloff(Editor& editor, float width, float scale) {
    struct Info {
        Falloff falloff;
        const char* name;
        const char* tooltip;
        int span;  // the number of control points that it begins with
    };
    constexpr std::array<Info, 2> kFalloffs{{
        {Falloff::sharp, "Sharp",
         "A drag pulls the surface to a peak at the grabbed point. Begins with 3 control points.",
         3},
        {Falloff::plateau, "Plateau",
         "A drag moves the surroundings of the grabbed point along with it, and falls off towards "
         "the edge. Begins with 5 control points, since fewer have no flat top.",
         5},
    }};
    ImGui::TextUnformatted("Falloff");
    const bool is_narrow = width < kNarrow * scale;
    const float gap = 0.5f * ImGui::GetStyle().ItemSpacing.x;
    const float each = is_narrow ? width : 0.5f * (width - gap);
    const Falloff present = editor.session().lattice_settings().falloff;
    for (const Info& info : kFalloffs) {
        if (!is_narrow && info.falloff == Falloff::plateau) ImGui::SameLine(0.0f, gap);
        if (toggle_button(info.name, info.falloff == present, each) && info.falloff != present) {
            editor.execute(command::Brush{.span = info.span, .falloff = info.falloff});
        }
        tooltip(info.tooltip);
    }
    draw_curve(editor.brush_profile(), width, scale);
}

// While the slider is held, Dear ImGui keeps its value.
void draw_span(Editor& editor, float width) {
    ImGui::TextUnformatted("Control points");
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("##span");
    const int present = editor.session().lattice_settings().span;
    const bool is_held = storage.GetInt(id, 0) > 0;
    int span = is_held ? storage.GetInt(id, 0) : present;
    ImGui::SetNextItemWidth(width);
    ImGui::SliderInt("##span", &span, 1, kMaxSpan, "%d", ImGuiSliderFlags_AlwaysClamp);
    storage.SetInt(id, ImGui::IsItemActive() ? span : 0);
    const BrushProfile& profile = editor.brush_profile();
    const bool is_sharp = profile.falloff() == Falloff::sharp;
    const std::string effect =
        is_sharp ? "More of them make a sharp drag narrower" : "More of them make a plateau wider";
    tooltip(("The number of control points along each axis of the brush's lattice. " + effect +
             ": now points move half as far as the grabbed one at " +
             rounded(profile.distance_at(0.5, kAlongAxis)) + " of the radius.")
                .c_str());
    if (ImGui::IsItemDeactivatedAfterEdit() && span != present) {
        editor.execute(command::Brush{.span = span});
    }
}

void draw_strength(Editor& editor, float width) {
    ImGui::TextUnformatted("Strength");
    auto percent = static_cast<float>(100.0 * editor.drag_strength);
    ImGui::SetNextItemWidth(width);
    if (ImGui::SliderFloat("##strength", &percent, 1.0f, 100.0f, "%.0f %%",
                           ImGuiSliderFlags_AlwaysClamp)) {
        editor.drag_strength = static_cast<double>(percent) / 100.0;
    }
    tooltip("How much of the cursor's way a dragged point follows.");
}

}  // namespace

void draw_brush_section(Editor& editor, float width, float scale) {
    const ShownSettings shown = editor.shown_settings();
    const std::optional<double> held = std::exchange(editor.radius_preview, std::nullopt);
    ImGui::BeginDisabled(editor.has_cage());
    if (shown.radius) {
        draw_radius(editor, width, held);
        draw_falloff(editor, width, scale);
        draw_span(editor, width);
        draw_strength(editor, width);
    }
    if (shown.connected) action_button(editor, Action::toggle_connected, width);
    if (shown.fold_free) action_button(editor, Action::toggle_fold_free, width);
    ImGui::EndDisabled();
}

}  // namespace pectin

#include "app/ui/falloff_curve.h"

#include <imgui.h>

#include <array>

#include "app/ui/action_widgets.h"
#include "app/ui/figure_text.h"
#include "app/ui/rows.h"

namespace pectin {
namespace {

constexpr int kSegments = 64;
constexpr float kLines = 3.4f;  // height in lines of text
constexpr Vec3 kAlongAxis{1.0, 0.0, 0.0};
const Vec3 kAlongDiagonal = glm::normalize(Vec3{1.0, 1.0, 0.0});

// The part of the window in which the curve is drawn.
struct Chart {
    ImVec2 low, high;  // the left end at weight 0, and the right end at weight 1

    ImVec2 at(double distance, double weight) const {
        return {low.x + (high.x - low.x) * static_cast<float>(0.5 + 0.5 * distance),
                low.y + (high.y - low.y) * static_cast<float>(weight)};
    }
};

void draw_half(ImDrawList& list, const Chart& chart, double half, float thickness) {
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.5f);
    list.AddLine(chart.at(-1.0, 0.0), chart.at(1.0, 0.0), faint, thickness);
    list.AddLine(chart.at(-half, 0.5), chart.at(half, 0.5), faint, thickness);
    for (const double side : {-half, half}) {
        list.AddLine(chart.at(side, 0.0), chart.at(side, 0.5), faint, thickness);
    }
}

}  // namespace

void draw_falloff_curve(const BrushProfile& profile) {
    begin_row("Curve");
    const float line = ImGui::GetTextLineHeight(), thickness = line / 16.0f;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, kLines * line);
    const ImVec2 to(from.x + size.x, from.y + size.y);
    ImGui::InvisibleButton("##curve", size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg),
                       ImGui::GetStyle().FrameRounding);
    const float margin = 0.4f * line;
    const Chart chart{{from.x + margin, to.y - margin}, {to.x - margin, from.y + margin}};
    const double half = profile.distance_at(0.5, kAlongAxis);
    draw_half(list, chart, half, thickness);
    std::array<ImVec2, kSegments + 1> points;
    for (int i = 0; i <= kSegments; ++i) {
        const double distance = 2.0 * i / kSegments - 1.0;
        points[static_cast<std::size_t>(i)] =
            chart.at(distance, profile.weight(distance * kAlongAxis));
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()),
                     ImGui::GetColorU32(ImGuiCol_CheckMark), 0, 2.0f * thickness);
    const std::string text =
        "How far the surface moves with the point that you grab, along an axis of the object. It "
        "moves half as far at " +
        formatted("%.3g", half) + " of the radius, and in the diagonal between two axes at " +
        formatted("%.3g", profile.distance_at(0.5, kAlongDiagonal)) + ".";
    tooltip("Curve", text.c_str());
}

}  // namespace pectin

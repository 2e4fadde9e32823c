#include "app/ui/axes_view.h"

#include <imgui.h>

#include <array>

namespace pectin {
namespace {

const std::array kColours{ImVec4(0.90f, 0.33f, 0.34f, 1.0f), ImVec4(0.50f, 0.75f, 0.26f, 1.0f),
                          ImVec4(0.33f, 0.56f, 0.93f, 1.0f)};
constexpr std::array kNames{"X", "Y", "Z"}, kNegativeNames{"-X", "-Y", "-Z"};
constexpr ImU32 kDisc = IM_COL32(255, 255, 255, 26);  // behind the axes, under the cursor
constexpr ImU32 kLabel = IM_COL32(16, 18, 22, 255), kHoveredLabel = IM_COL32(255, 255, 255, 255);
constexpr float kLineWidth = 2.0f, kRimWidth = 1.5f;
// The axes become darker towards the back, down to this factor.
constexpr float kDarkest = 0.55f;
constexpr float kNegativeFill = 0.35f;  // opacity

ImVec2 at(const Vec2& v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

ImU32 shade(const AxesGizmo::End& end, float opacity = 1.0f) {
    ImVec4 colour = kColours[static_cast<std::size_t>(end.end.axis)];
    const auto nearness = static_cast<float>(0.5 + 0.5 * end.nearness);
    const float light = kDarkest + (1.0f - kDarkest) * nearness;
    colour = {light * colour.x, light * colour.y, light * colour.z, opacity};
    return ImGui::ColorConvertFloat4ToU32(colour);
}

void draw_label(ImDrawList& list, const AxesGizmo::End& end, ImU32 colour) {
    const auto axis = static_cast<std::size_t>(end.end.axis);
    const char* const label = end.end.is_positive ? kNames[axis] : kNegativeNames[axis];
    const ImVec2 size = ImGui::CalcTextSize(label), centre = at(end.at);
    list.AddText(ImVec2(centre.x - 0.5f * size.x, centre.y - 0.5f * size.y), colour, label);
}

void draw_end(ImDrawList& list, const AxesGizmo& gizmo, const AxesGizmo::End& end, bool is_hovered,
              float scale) {
    const auto radius = static_cast<float>(gizmo.end_radius);
    if (end.end.is_positive) {
        list.AddLine(at(gizmo.centre), at(end.at), shade(end), kLineWidth * scale);
        list.AddCircleFilled(at(end.at), radius, shade(end));
    } else {
        list.AddCircleFilled(at(end.at), radius, shade(end, kNegativeFill));
        list.AddCircle(at(end.at), radius - 0.5f * kRimWidth * scale, shade(end), 0,
                       kRimWidth * scale);
    }
    if (end.end.is_positive || is_hovered) {
        draw_label(list, end, is_hovered ? kHoveredLabel : kLabel);
    }
}

}  // namespace

void draw_axes(const Editor& editor, float scale) {
    const ViewControl& view = editor.view_control();
    const std::optional<AxesGizmo> gizmo = view.axes();
    if (!gizmo) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Pointer& pointer = editor.pointer();
    const bool is_hovered = pointer.is_in_viewport && gizmo->contains(pointer.at);
    if (is_hovered) {
        list.AddCircleFilled(at(gizmo->centre), static_cast<float>(gizmo->radius), kDisc);
    }
    const std::optional<AxisEnd> hovered =
        pointer.is_in_viewport ? view.axis_at(pointer.at) : std::nullopt;
    for (const AxesGizmo::End& end : gizmo->ends) {
        draw_end(list, *gizmo, end, hovered == end.end, scale);
    }
}

}  // namespace pectin

#include "app/axes_gizmo.h"

#include <algorithm>

namespace pectin {
namespace {

// At scale 1.
constexpr double kRadius = 44.0, kEndRadius = 9.5, kMargin = 12.0;
// The gizmo takes at most this part of the area's width and height.
constexpr double kLargestPart = 0.6;

}  // namespace

Vec3 AxisEnd::direction() const {
    Vec3 direction{0.0};
    direction[axis] = is_positive ? 1.0 : -1.0;
    return direction;
}

bool AxesGizmo::contains(const Vec2& at) const { return glm::distance(at, centre) <= radius; }

std::optional<AxisEnd> AxesGizmo::end_at(const Vec2& at) const {
    for (auto end = ends.rbegin(); end != ends.rend(); ++end) {
        if (glm::distance(at, end->at) <= end_radius) return end->end;
    }
    return std::nullopt;
}

std::optional<AxesGizmo> axes_gizmo(const Camera& camera, const ScreenBox& area, double scale) {
    const Vec2 low = glm::min(area.from, area.to), high = glm::max(area.from, area.to);
    AxesGizmo gizmo{.radius = scale * kRadius, .end_radius = scale * kEndRadius};
    const Vec2 size = high - low;
    if (2.0 * gizmo.radius + scale * kMargin > kLargestPart * std::min(size.x, size.y)) return {};
    const double inset = gizmo.radius + scale * kMargin;
    gizmo.centre = {high.x - inset, low.y + inset};
    const double reach = gizmo.radius - gizmo.end_radius;
    for (std::size_t i = 0; i < gizmo.ends.size(); ++i) {
        const AxisEnd end{static_cast<int>(i / 2), i % 2 == 0};
        const Vec3 direction = end.direction();
        const Vec2 aside{glm::dot(direction, camera.right()),
                         -glm::dot(direction, camera.true_up())};
        gizmo.ends[i] = {end, gizmo.centre + reach * aside, -glm::dot(direction, camera.forward())};
    }
    std::ranges::stable_sort(gizmo.ends, {}, &AxesGizmo::End::nearness);
    return gizmo;
}

}  // namespace pectin

#include "app/pins.h"

namespace pectin {
namespace {

constexpr double kReach = 9.0;  // of a marker, in pixels
// How far behind the surface under the cursor a pin in it may lie, in pixels: the surface beside
// the pin slopes.
constexpr double kSlack = 30.0;

bool is_behind(const View& view, const Vec3& point, const std::optional<Pick>& surface) {
    return surface && view.depth(point) >
                          view.depth(surface->point) + kSlack * view.pixel_length(surface->point);
}

}  // namespace

std::optional<Pins::Marker> Pins::at(const View& view, const Vec2& cursor,
                                     const std::optional<Pick>& surface,
                                     const std::optional<MirrorPlane>& symmetry) const {
    std::optional<Marker> found;
    double nearest = kReach;
    const auto consider = [&](std::size_t i, const Vec3& point) {
        const std::optional<Vec2> seen = view.project(point);
        if (!seen || is_behind(view, point, surface)) return;
        const double distance = glm::distance(*seen, cursor);
        if (distance > nearest) return;
        nearest = distance;
        found = Marker{i, point};
    };
    for (std::size_t i = 0; i < points_.size(); ++i) {
        consider(i, points_[i]);
        if (symmetry) consider(i, symmetry->image(points_[i]));
    }
    return found;
}

bool Pins::toggle(const View& view, const Vec2& cursor, const std::optional<Pick>& surface,
                  const std::optional<MirrorPlane>& symmetry) {
    if (const auto there = at(view, cursor, surface, symmetry)) {
        points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(there->pin));
        return true;
    }
    if (!surface) return false;
    points_.push_back(surface->point);
    return true;
}

}  // namespace pectin

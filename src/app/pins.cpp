#include "app/pins.h"

namespace pectin {
namespace {

constexpr double kPickRadius = 9.0;  // of a marker, in pixels
// A pin may lie behind the surface under the cursor by this many pixels, because the surface beside
// the pin may slope.
constexpr double kDepthTolerance = 30.0;

bool is_behind(const View& view, const Vec3& point, const std::optional<Pick>& surface) {
    if (!surface) return false;
    const double tolerance = kDepthTolerance * view.pixel_length(surface->point);
    return view.depth(point) > view.depth(surface->point) + tolerance;
}

}  // namespace

std::optional<Pins::Marker> Pins::at(const View& view, const Vec2& cursor,
                                     const std::optional<Pick>& surface,
                                     const std::optional<MirrorPlane>& symmetry) const {
    std::optional<Marker> found;
    double nearest = kPickRadius;
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

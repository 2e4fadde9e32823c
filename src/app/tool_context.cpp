#include "app/tool_context.h"

#include <cmath>

namespace pectin {
namespace {

// Limits of the brush's radius, in diagonals of the object's box.
constexpr double kMinRadius = 1e-3, kMaxRadius = 2.0;
constexpr Range kPixels{4.0, 2000.0};  // limits of the brush's radius on the screen
// A point within this many pixels of the plane of symmetry is moved onto it.
constexpr double kSnapDistance = 8.0;

}  // namespace

std::optional<Pick> ToolContext::pick_at_cursor() {
    return workspace().session().pick(ray_through_cursor());
}

Pick ToolContext::snapped_to_symmetry_plane(Pick pick) const {
    const auto& plane = session().symmetry();
    const double reach = kSnapDistance * view().pixel_length(pick.point);
    if (plane && std::abs(plane->offset(pick.point)) < reach) pick.point = plane->onto(pick.point);
    return pick;
}

double ToolContext::min_radius() const { return kMinRadius * workspace().diagonal(); }
double ToolContext::max_radius() const { return kMaxRadius * workspace().diagonal(); }

double ToolContext::pixel_length_at_cursor() const {
    return view().pixel_length(hover() ? hover()->point : view().camera.target);
}

double ToolContext::radius_value() const {
    if (radius_being_set) return *radius_being_set;
    if (radius_preview) return *radius_preview;
    switch (brush_size_.unit) {
        case RadiusUnit::share:
            return brush_size_.share;
        case RadiusUnit::model:
            return workspace().radius();
        case RadiusUnit::screen:
            return brush_size_.pixels;
    }
    return brush_size_.share;
}

Range ToolContext::radius_range() const {
    switch (brush_size_.unit) {
        case RadiusUnit::share:
            return {kMinRadius, kMaxRadius};
        case RadiusUnit::model:
            return {min_radius(), max_radius()};
        case RadiusUnit::screen:
            return kPixels;
    }
    return {kMinRadius, kMaxRadius};
}

double ToolContext::model_radius(double value, const Vec3& at) const {
    switch (brush_size_.unit) {
        case RadiusUnit::share:
            value *= workspace().diagonal();
            break;
        case RadiusUnit::model:
            break;
        case RadiusUnit::screen:
            value *= view().pixel_length(at);
            break;
    }
    return std::clamp(value, min_radius(), max_radius());
}

double ToolContext::radius() const {
    const bool is_set = brush_size_.unit != RadiusUnit::screen && !is_setting_radius();
    if (is_set) return workspace().radius();
    return model_radius(radius_value(), hover() ? hover()->point : view().camera.target);
}

const BrushProfile& ToolContext::brush_profile() const {
    const auto& [radius, span, falloff, cage] = session().lattice_settings();
    if (!profile_ || profile_->span() != span || profile_->falloff() != falloff) {
        profile_ = std::make_unique<BrushProfile>(span, falloff);
    }
    return *profile_;
}

std::optional<Lattice> ToolContext::editable_cage() const {
    return display.lattice ? session().lattice_settings().cage : std::nullopt;
}

}  // namespace pectin

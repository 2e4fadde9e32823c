#include "app/tool_context.h"

#include <cmath>

namespace pectin {
namespace {

// Limits of the brush's radius, in diagonals of the object's box.
constexpr double kMinRadius = 1e-3, kMaxRadius = 2.0;
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

std::optional<Lattice> ToolContext::editable_cage() const {
    return display.lattice ? session().lattice_settings().cage : std::nullopt;
}

}  // namespace pectin

#include "app/tools/repeat_drag.h"

#include <cmath>

#include "app/tools/sculptor.h"

namespace pectin {
namespace {

// The smallest rotation that takes one unit vector to another.
Mat3 rotation_between(const Vec3& from, const Vec3& to) {
    const Vec3 axis = glm::cross(from, to);
    const double cosine = glm::dot(from, to);
    if (cosine < -1.0 + 1e-9) {  // half a turn about any axis across them
        const Vec3 other = std::abs(from.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
        const Vec3 across = glm::normalize(glm::cross(from, other));
        return 2.0 * glm::outerProduct(across, across) - Mat3{1.0};
    }
    // Rodrigues' formula with the sine in the length of the axis.
    const Mat3 cross{Vec3{0.0, axis.z, -axis.y}, Vec3{-axis.z, 0.0, axis.x},
                     Vec3{axis.y, -axis.x, 0.0}};
    return Mat3{1.0} + cross + cross * cross / (1.0 + cosine);
}

}  // namespace

std::optional<command::Drag> repeated_drag(ToolContext& context) {
    if (!context.last_drag || context.has_cage() || !context.pointer().is_in_viewport) return {};
    std::optional<Pick> pick = context.pick_at_cursor();
    if (!pick) return {};
    pick = context.snapped_to_symmetry_plane(*pick);
    context.use_radius_at(pick->point);
    const auto& [last, normal] = *context.last_drag;
    const Move& before = last.moves.front();
    const Mat3 rotation = rotation_between(normal, pick->normal);
    const auto& plane = context.session().symmetry();
    const int span = context.session().lattice_settings().span;
    const double radius = context.workspace().radius();
    const double cell = brush_lattice(pick->point, radius, span).smallest_cell_extent();
    const auto moved = [&](const Vec3& point) {
        const Vec3 to = pick->point + rotation * (point - before.from);
        return plane ? on_own_side(*plane, cell, pick->point, to) : to;
    };
    Move move = before;
    move.from = pick->point;
    move.to = moved(before.to);
    if (move.twist) move.twist->axis = rotation * move.twist->axis;
    command::Drag drag{.moves = {move},
                       .pins = {context.pins().points().begin(), context.pins().points().end()},
                       .connected = context.drag_options.connected,
                       .fold_free = context.drag_options.fold_free};
    for (const Vec3& waypoint : last.via) drag.via.push_back(moved(waypoint));
    return drag;
}

}  // namespace pectin

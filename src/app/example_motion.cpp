#include "app/example_motion.h"

#include <cmath>
#include <optional>
#include <variant>

#include "app/command_kind.h"

namespace pectin {
namespace {

// The point that has gone this part of the way along the waypoints.
Vec3 along(const std::vector<Vec3>& way, double part) {
    double left = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) left += glm::distance(way[i - 1], way[i]);
    left *= part;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double length = glm::distance(way[i - 1], way[i]);
        if (left <= length && length > 0.0) return glm::mix(way[i - 1], way[i], left / length);
        left -= length;
    }
    return way.back();
}

std::vector<Vec3> way_of(const command::Drag& drag) {
    std::vector<Vec3> way{drag.moves.front().from};
    way.insert(way.end(), drag.via.begin(), drag.via.end());
    way.push_back(drag.moves.front().to);
    return way;
}

}  // namespace

bool is_motion(const Command& command) {
    return is_any_of<command::Drag, command::Control>(command);
}

Done ExampleMotion::begin(Session& session, const Command& command) {
    const auto* drag = std::get_if<command::Drag>(&command);
    Done done = drag ? begin_drag(session, *drag)
                     : begin_control(session, std::get<command::Control>(command));
    if (done) command_ = command;
    part_ = 0.0;
    return done;
}

Done ExampleMotion::begin_drag(Session& session, const command::Drag& drag) {
    std::vector<Vec3> handles;
    for (const Move& move : drag.moves) handles.push_back(move.from);
    return session.begin_drag(handles, drag.pins, {drag.connected, drag.fold_free});
}

Done ExampleMotion::begin_control(Session& session, const command::Control& control) {
    const std::optional<Lattice>& cage = session.lattice_settings().cage;
    if (!cage) return Refusal{"there is no cage"};
    std::vector<IVec3> indices;
    rest_.clear();
    for (const auto& point : control.points) {
        indices.push_back(point.index);
        rest_.push_back(cage->rest(cage->control_of_user_index(point.index)));
    }
    return session.begin_control(indices);
}

// A part of the displacements, twists and scales; the first move follows the waypoints.
std::vector<Move> ExampleMotion::moves_at(const command::Drag& drag, double part) const {
    std::vector<Move> moves = drag.moves;
    for (Move& move : moves) {
        move.to = glm::mix(move.from, move.to, part);
        if (move.twist) move.twist->degrees *= part;
        move.scale = std::pow(move.scale, part);
    }
    moves.front().to = along(way_of(drag), part);
    return moves;
}

Done ExampleMotion::move_to(Session& session, double part) {
    part_ = part;
    if (const auto* drag = std::get_if<command::Drag>(&*command_)) {
        return session.drag_to(moves_at(*drag, part));
    }
    const auto& points = std::get<command::Control>(*command_).points;
    std::vector<Vec3> targets;
    for (std::size_t i = 0; i < points.size(); ++i) {
        targets.push_back(glm::mix(rest_[i], points[i].to, part));
    }
    return session.control_to(targets);
}

void ExampleMotion::overlay(const Session& session, Overlay& overlay) const {
    if (!command_) return;
    const auto* drag = std::get_if<command::Drag>(&*command_);
    const auto& plane = session.symmetry();
    if (drag) {
        for (const Move& move : moves_at(*drag, part_)) {
            add_drag(overlay, move.from, move.to);
            if (plane && plane->offset(move.from) != 0.0) {
                add_drag(overlay, plane->image(move.from), plane->image(move.to), true);
            }
        }
        for (const Vec3& pin : drag->pins) add_pin(overlay, pin);
        return;
    }
    for (const LatticeField& field : session.active_lattices()) {
        add_lattice(overlay, field.lattice(), field.displacements());
    }
    const auto& points = std::get<command::Control>(*command_).points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        add_control_point(overlay, glm::mix(rest_[i], points[i].to, part_), true, false);
    }
}

}  // namespace pectin

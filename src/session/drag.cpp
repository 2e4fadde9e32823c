// Drags: from a script in one go, or frame by frame with the mouse.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/decimal.h"
#include "session/session_state.h"

namespace pectin {
namespace {

// Beyond this many diagonals of object and zone a drag is a slip of the hand or of a script, and
// squares of lengths would lose all digits of what stays.
constexpr double kLargestDrag = 1e6;

bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::vector<Vec3> Session::State::DragInHand::displacements() const {
    std::vector<Vec3> d;
    for (const command::Drag::Move& move : drag.moves) d.push_back(move.to - move.from);
    return d;
}

Refusal Session::State::begin_drag(std::span<const Vec3> points, std::span<const Vec3> pins) {
    assert(!in_hand && !points.empty());
    if (!has_object()) return kNoObject;
    Stopwatch stopwatch;
    const Lattice lattice = lattice_settings.lattice(points.front(), diagonal);
    if (!lattice.is_valid() || !is_finite(lattice.influenced_zone().extent())) {
        return "the lattice has no usable size (radius or cells of 0, or beyond numbers); set the "
               "brush radius or the cage to about the size of what is to move";
    }
    auto solved = DragSolver::create(lattice, points, pins);
    if (const auto* refusal = std::get_if<DragRefusal>(&solved)) return refusal->what;

    command::Drag drag{{}, {pins.begin(), pins.end()}};
    for (const Vec3& point : points) drag.moves.push_back({point, point});
    in_hand = std::make_unique<DragInHand>(
        DragInHand{std::move(drag), lattice, std::move(std::get<DragSolver>(solved)), {}});
    in_hand->measured.seconds.solve = stopwatch.lap();
    const Box zone = lattice.influenced_zone();
    active->begin(face_tree().faces_meeting(zone, *mesh), zone);
    Warp warp{{{in_hand->solver.field(), std::vector<Vec3>(points.size())}}};
    in_hand->gesture = std::make_unique<Gesture>(
        *active, std::move(warp),
        adapt_settings.enabled ? std::optional(limits(lattice)) : std::nullopt);
    in_hand->measured.influenced_vertices = in_hand->gesture->influenced_vertices();
    in_hand->measured.seconds.begin = stopwatch.lap();
    return std::nullopt;
}

// Takes the targets, or says why not and keeps those before.
Refusal Session::State::set_targets(std::span<const Vec3> targets) {
    std::vector<command::Drag::Move>& moves = in_hand->drag.moves;
    assert(targets.size() == moves.size());
    const double most = kLargestDrag * (diagonal + in_hand->lattice.influenced_zone().diagonal());
    std::vector<Vec3> displacements;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        displacements.push_back(targets[i] - moves[i].from);
        if (!(glm::length(displacements.back()) <= most)) {
            return "the drag from " + decimal(moves[i].from) + " to " + decimal(targets[i]) +
                   " goes more than a million times the size of the object; the most is " +
                   decimal(most);
        }
    }
    if (const auto refusal = in_hand->solver.check(displacements)) return refusal->what;
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i].to = targets[i];
    return std::nullopt;
}

Refusal Session::State::drag_to(std::span<const Vec3> targets) {
    assert(in_hand);
    if (Refusal refusal = set_targets(targets)) return refusal;
    const std::size_t edited = in_hand->gesture->edited_faces().size();
    in_hand->gesture->frame(in_hand->displacements());
    const auto faces = in_hand->gesture->edited_faces().subspan(edited);
    dirty.faces.insert(dirty.faces.end(), faces.begin(), faces.end());
    const std::vector<WedgeId> wedges = in_hand->gesture->moved_wedges();
    dirty.wedges.insert(dirty.wedges.end(), wedges.begin(), wedges.end());
    return std::nullopt;
}

std::optional<command::Drag> Session::State::end_drag() {
    assert(in_hand);
    const std::vector<Vec3> displacements = in_hand->displacements();
    // A gesture that moves nothing does nothing.
    const bool moves_nothing = std::all_of(displacements.begin(), displacements.end(),
                                           [](const Vec3& d) { return d == Vec3{0.0}; });
    last = in_hand->measured;
    lattice_in_use = in_hand->lattice;
    folded = 0;
    floor_hit = budget_hit = false;
    if (moves_nothing) {
        cancel_drag();
        return std::nullopt;
    }
    Stopwatch stopwatch;
    // What the frames have shown and the commit takes back has to be shown anew, too.
    const auto shown = in_hand->gesture->edited_faces();
    dirty.faces.insert(dirty.faces.end(), shown.begin(), shown.end());
    MeshChange change = in_hand->gesture->commit(displacements);
    note(in_hand->gesture->last_frame());
    folded = in_hand->gesture->folded_vertices();
    const command::Drag drag = std::move(in_hand->drag);
    in_hand.reset();
    const bool changed = !change.is_empty();
    add_step(drag, std::move(change));
    last.seconds.commit =
        stopwatch.lap() - last.seconds.deform - last.seconds.refine - last.seconds.decimate;
    return changed ? std::optional(drag) : std::nullopt;
}

void Session::State::cancel_drag() {
    assert(in_hand);
    const std::vector<FaceId> faces = in_hand->gesture->cancel();
    in_hand.reset();
    follow(faces);
}

Refusal Session::State::run(const command::Drag& drag) {
    if (drag.moves.empty()) return "a drag needs at least one move, from a point to another";
    std::vector<Vec3> points, targets;
    for (const command::Drag::Move& move : drag.moves) {
        points.push_back(move.from);
        targets.push_back(move.to);
    }
    if (Refusal refusal = begin_drag(points, drag.pins)) return refusal;
    if (Refusal refusal = set_targets(targets)) {
        cancel_drag();
        return refusal;
    }
    end_drag();
    return std::nullopt;
}

}  // namespace pectin

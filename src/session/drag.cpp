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
    auto begun = std::make_unique<DragInHand>(
        DragInHand{std::move(drag), lattice, std::move(std::get<DragSolver>(solved)), {}});
    begun->measured.seconds.solve = stopwatch.lap();
    const Box zone = lattice.influenced_zone();
    const std::vector<FaceId> faces = face_tree().faces_meeting(zone, *mesh);
    Warp warp{{DragStep{begun->solver.field(), std::vector<Vec3>(points.size())}}};
    // From here on what throws (memory) ends the gesture, and the session is as it was.
    begun->gesture = std::make_unique<Gesture>(
        *active, faces, std::move(warp),
        adapt_settings.enabled ? std::optional(limits(lattice)) : std::nullopt);
    begun->measured.influenced_vertices = begun->gesture->influenced_vertices();
    begun->measured.seconds.begin = stopwatch.lap();
    in_hand = std::move(begun);
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
    in_hand->gesture->frame(in_hand->displacements());
    // Corners of new faces may lie where nothing moves: they are shown with their faces.
    show(in_hand->gesture->take_edited_faces());
    if (!dirty.everything) in_hand->gesture->append_moved_wedges(dirty.wedges);
    return std::nullopt;
}

std::optional<command::Drag> Session::State::end_drag() {
    assert(in_hand);
    const std::vector<Vec3> displacements = in_hand->displacements();
    // A gesture that moves nothing does nothing.
    const bool moves_nothing = std::all_of(displacements.begin(), displacements.end(),
                                           [](const Vec3& d) { return d == Vec3{0.0}; });
    last = in_hand->measured;
    if (moves_nothing) {
        cancel_drag();
        return std::nullopt;
    }
    Stopwatch stopwatch;
    MeshChange change = in_hand->gesture->commit(displacements);
    // What frames have shown and the commit has taken back is shown anew, too.
    show(in_hand->gesture->take_edited_faces());
    lattice_in_use = in_hand->lattice;
    note(in_hand->gesture->last_frame());
    folded = in_hand->gesture->folded_vertices();
    const command::Drag drag = std::move(in_hand->drag);
    in_hand.reset();
    add_step(drag, std::move(change));
    last.seconds.commit =
        stopwatch.lap() - last.seconds.deform - last.seconds.refine - last.seconds.decimate;
    return drag;
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
    try {
        if (Refusal refusal = set_targets(targets)) {
            cancel_drag();
            return refusal;
        }
        end_drag();
    } catch (...) {
        if (in_hand) cancel_drag();
        throw;
    }
    return std::nullopt;
}

}  // namespace pectin

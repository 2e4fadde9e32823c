// Drags of points: from a script as one command, or frame by frame with the mouse.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "command/check.h"
#include "geometry/decimal.h"
#include "session/session_state.h"

namespace pectin {
namespace {

// A drag longer than this many diagonals of object and zone is a mistake of a hand or of a script.
// Squares of such lengths would lose all digits of the coordinates of other points.
constexpr double kLargestDrag = 1e6;

// The limit for the size of a lattice, in multiples of the object and of its distance from the
// origin. Beyond it too few digits are left of the differences between points of the object.
constexpr double kLargestLattice = 1e6;

bool has_no_effect(const command::Drag& drag) {
    const Vec3& from = drag.moves.front().from;
    return std::ranges::all_of(drag.moves,
                               [](const Move& m) { return m.to == m.from && !rotates(m); }) &&
           std::ranges::all_of(drag.via, [&](const Vec3& waypoint) { return waypoint == from; });
}

// Sets what the last step does if it is the whole last segment of the drag.
void set_last_motions(std::span<const Move> moves, std::span<const Vec3> via,
                      std::vector<HandleMotion>& motions) {
    motions.clear();
    for (const Move& move : moves) {
        const bool is_on_waypoints = motions.empty() && !via.empty();
        const Vec3& at = is_on_waypoints ? via.back() : move.from;
        motions.push_back({move.to - at, jacobian(move)});
    }
}

// The refusal that a script gets for these moves, if it gets one, and else the one that was found.
Refusal in_words_of_scripts(std::span<const Move> moves, const Refusal& found) {
    const Done done = check(command::Drag{.moves = {moves.begin(), moves.end()}});
    return done ? found : done.refusal();
}

Refusal refusal_of(const DragRefusal& refused) {
    return {.reason = refused.what, .kind = refused.kind};
}

}  // namespace

DragPlan Session::State::plan_of(const command::Drag& drag) const {
    const bool is_brush = !lattice_settings.cage.has_value();
    return {.moves = drag.moves,
            .pins = drag.pins,
            .via = drag.via,
            .fold_free = drag.fold_free,
            .plane = symmetry,
            .lattice = lattice_settings.lattice(drag.moves.front().from, diagonal),
            .is_centred_on_point = is_brush,
            .falloff = is_brush ? lattice_settings.falloff : Falloff::sharp};
}

Done Session::State::check_lattice(const Lattice& lattice) const {
    const Vec3 extent = lattice.influenced_zone().extent();
    if (!lattice.is_valid() || !is_finite(extent)) {
        return Refusal{
            "the lattice has no usable size (radius or cells of 0, or beyond numbers); set the "
            "brush radius or the cage to about the size of what is to move"};
    }
    const double size = diagonal + largest_coordinate;
    const double most = size > 0.0 ? kLargestLattice * size : kOff;
    if (glm::length(extent) > most) {
        return Refusal{
            "the lattice is more than a million times as large as the object; set the brush "
            "radius or the cage to about the size of what is to move"};
    }
    if (!symmetry) return {};
    if (std::abs(symmetry->at) > most || !mirror_image(*symmetry, lattice).is_valid()) {
        return Refusal{
            "the symmetry plane is more than a million times the size of the object away; set "
            "it through the object, or switch symmetry off"};
    }
    return {};
}

Done Session::State::check_targets(std::span<const Move> moves, std::span<const Vec3> via,
                                   double reach) const {
    const double most = kLargestDrag * (diagonal + reach);
    const auto check = [&](const Vec3& from, const Vec3& to) -> Done {
        if (glm::length(to - from) <= most) return {};
        return Refusal{"the drag from " + decimal(from) + " to " + decimal(to) +
                           " goes more than a million times the size of the object; the most is " +
                           decimal(most),
                       "moves", "too_far"};
    };
    for (const Move& move : moves) {
        if (Done done = check(move.from, move.to); !done) return done;
    }
    for (const Vec3& waypoint : via) {
        if (Done done = check(moves.front().from, waypoint); !done) return done;
    }
    return {};
}

// Plans the drag and begins its gesture. It replaces the gesture of an earlier frame, if any.
Done Session::State::embed(ActiveGesture& begun) {
    Stopwatch stopwatch;
    auto result = plan_drag(plan_of(begun.drag));
    if (const auto* refused = std::get_if<DragRefusal>(&result)) return refusal_of(*refused);
    PlannedDrag planned = std::move(std::get<PlannedDrag>(result));
    const std::size_t steps_left = planned.warp.steps.size() - planned.last_segment;
    const bool is_alone = begun.drag.moves.size() == 1 && !rotates(begun.drag.moves.front());
    begun.is_one_step_left = steps_left == 1;
    if (begun.gesture && steps_left > 1 && is_alone) {
        // Its steps become waypoints, so that the next frame only has to change the last step.
        begun.drag.via.insert(begun.drag.via.end(),
                              planned.points.end() - static_cast<std::ptrdiff_t>(steps_left - 1),
                              planned.points.end());
        begun.is_one_step_left = true;
    }
    begun.guard = begun.drag.fold_free ? std::make_unique<FoldGuard>(planned.last) : nullptr;
    begun.solver.emplace(std::move(planned.last));
    begun.last_step.emplace(DragStep{
        .field = begun.solver->field(),
        .displacements = std::vector<Vec3>(begun.solver->field().weight_count(), Vec3{0.0}),
        .symmetry = begun.solver->symmetry()});
    begun.plan = plan_of(begun.drag);
    begun.measured.seconds.solve = stopwatch.lap();

    // Faces are searched and embedded in the rest state, so the earlier gesture is taken back.
    if (begun.gesture) {
        if (const auto changed = begun.gesture->cancel()) {
            mark_dirty(*changed);
        } else {
            update_everything();
        }
        begun.gesture.reset();
    }
    auto faces = faces_of(begun.drag, zones_on_both_sides(planned.warp));
    if (!faces) return faces.refusal();
    // If memory runs out from here on, there is no gesture, and the object is in its rest state.
    GestureFaces& found = *faces;
    start_gesture(begun, found, std::move(planned.warp));
    begun.staying = std::move(found.staying);
    begun.measured.seconds.begin = stopwatch.lap();
    return {};
}

Done Session::State::begin_drag(const command::Drag& drag) {
    assert(!active_gesture);
    if (!has_object()) return no_object();
    if (drag.moves.empty())
        return Refusal{"a drag needs at least one move, from a point to another", "moves"};
    const Lattice lattice = lattice_settings.lattice(drag.moves.front().from, diagonal);
    if (Done done = check_lattice(lattice); !done) return done;
    auto begun = std::make_unique<ActiveGesture>();
    begun->drag = drag;
    begun->reach = lattice.influenced_zone().diagonal();
    if (Done done = check_targets(drag.moves, drag.via, begun->reach); !done) return done;
    if (Done done = embed(*begun); !done) return done;
    active_gesture = std::move(begun);
    return {};
}

// Whether the last step alone can reach the targets. Refuses targets that cannot be reached at all.
Result<bool> Session::State::is_single_step(std::span<const Move> asked) {
    ActiveGesture& active_drag = *active_gesture;
    const command::Drag& before = active_drag.drag;
    if (!active_drag.is_one_step_left) return false;
    for (std::size_t m = 0; m < asked.size(); ++m) {
        if (rotates(asked[m]) != rotates(before.moves[m])) return false;
        if (before.fold_free && least_steps(asked[m]) > 1) return false;
    }
    active_drag.plan.moves.assign(asked.begin(), asked.end());
    set_last_motions(asked, before.via, active_drag.motions);
    if (const auto refused = check_drag(active_drag.plan)) return refusal_of(*refused);
    if (const auto refused = active_drag.solver->check(active_drag.motions)) {
        return refusal_of(*refused);
    }
    if (!active_drag.guard) return true;
    active_drag.solver->set_motions(active_drag.motions, *active_drag.last_step);
    return active_drag.guard->limit(*active_drag.last_step) >= 1.0;
}

// Whether the last step goes more than half as far as the proof allows.
bool Session::State::is_past_half_way() {
    ActiveGesture& active_drag = *active_gesture;
    set_last_motions(active_drag.drag.moves, active_drag.drag.via, active_drag.motions);
    active_drag.solver->set_motions(active_drag.motions, *active_drag.last_step);
    for (Vec3& d : active_drag.last_step->displacements) d *= 2.0;
    return active_drag.is_one_step_left && active_drag.guard->limit(*active_drag.last_step) < 1.0;
}

// Plans the active drag anew, for other targets.
Done Session::State::replan(std::span<const Move> asked) {
    ActiveGesture next{.drag = active_gesture->drag,
                       .reach = active_gesture->reach,
                       .measured = active_gesture->measured};
    next.drag.moves.assign(asked.begin(), asked.end());
    if (next.drag.fold_free && asked.size() == 1 && is_past_half_way()) {
        next.drag.via.push_back(active_gesture->drag.moves.front().to);
    }
    next.gesture = std::move(active_gesture->gesture);
    const Done done = embed(next);
    if (!done && next.gesture) {  // the present gesture stays
        active_gesture->gesture = std::move(next.gesture);
    } else {
        next.asked = std::move(active_gesture->asked);  // `asked` may refer to it
        *active_gesture = std::move(next);
    }
    return done;
}

// A frame that needs no new plan allocates nothing, and copies no more than the moves.
Done Session::State::drag_to(std::span<const Move> asked) {
    assert(active_gesture && active_gesture->gesture && !active_gesture->is_control());
    if (Done done = check_targets(asked, {}, active_gesture->reach); !done) return done;
    const Result<bool> is_single = is_single_step(asked);
    if (!is_single) return in_words_of_scripts(asked, is_single.refusal());
    if (*is_single) {
        active_gesture->drag.moves.assign(asked.begin(), asked.end());
    } else if (const Done done = replan(asked); !done) {
        return in_words_of_scripts(asked, done.refusal());
    }
    update_frame(last_displacements());
    return {};
}

// The displacements of the last step: those that the drag asks for now if this step is the whole
// last segment, and otherwise those that were planned. Valid until the next frame.
std::span<const Vec3> Session::State::last_displacements() {
    ActiveGesture& active_drag = *active_gesture;
    if (!active_drag.is_one_step_left) {
        const std::span<const Vec3> planned =
            displacements_of(active_drag.gesture->warp().steps.back());
        active_drag.displacements.assign(planned.begin(), planned.end());
        return active_drag.displacements;
    }
    set_last_motions(active_drag.drag.moves, active_drag.drag.via, active_drag.motions);
    const DragSolver& solver = *active_drag.solver;
    if (solver.field().weight_count() > kMostWeights) {
        active_drag.displacements = solver.displacements(active_drag.motions);
        return active_drag.displacements;
    }
    solver.set_motions(active_drag.motions, *active_drag.last_step);
    return active_drag.last_step->displacements;
}

std::optional<command::Drag> Session::State::end_drag() {
    assert(active_gesture && active_gesture->gesture && !active_gesture->is_control());
    // Copied before the commit, since a copy after it could run out of memory.
    std::optional<command::Drag> drag = active_gesture->drag;
    const bool is_noop = has_no_effect(*drag);
    commit(last_displacements(), is_noop);
    if (is_noop) drag.reset();
    return drag;
}

Done Session::State::run(const command::Drag& drag) {
    if (Done done = begin_drag(drag); !done) return done;
    try {
        end_drag();
    } catch (...) {
        if (active_gesture) cancel_drag();
        throw;
    }
    return {};
}

}  // namespace pectin

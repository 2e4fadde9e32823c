// Drags: from a script in one go, or frame by frame with the mouse.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "ffd/injectivity.h"
#include "geometry/decimal.h"
#include "mesh/connected_part.h"
#include "session/session_state.h"

namespace pectin {
namespace {

// Beyond this many diagonals of object and zone a drag is a slip of the hand or of a script, and
// squares of lengths would lose all digits of what stays.
constexpr double kLargestDrag = 1e6;

// A lattice larger than this many times the object and its distance from the origin moves nothing
// that a hand could mean, and too few digits are left of the differences between its points.
constexpr double kLargestLattice = 1e6;

// A vertex this near to a dragged point, in its largest coordinate, is that point. Mirror images
// differ by rounding, some units in the last place a drag.
constexpr double kSamePoint = 0x1p-40;

double largest_component(const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Turn turn_of(const command::Drag::Move& move) {
    Turn turn{.scale = move.scale};
    if (move.twist) {
        turn.axis = move.twist->axis;
        turn.degrees = move.twist->degrees;
    }
    return turn;
}

bool turns(const command::Drag::Move& move) { return !turn_of(move).is_none(); }

bool moves_nothing(const command::Drag& drag) {
    const bool goes_nowhere =
        std::all_of(drag.moves.begin(), drag.moves.end(),
                    [](const auto& move) { return move.to == move.from && !turns(move); });
    return goes_nowhere && std::all_of(drag.via.begin(), drag.via.end(), [&](const Vec3& point) {
               return point == drag.moves.front().from;
           });
}

// What the last step is asked for where it makes up the last segment.
std::vector<GripMotion> last_motions(const command::Drag& drag) {
    std::vector<GripMotion> motions;
    for (const auto& move : drag.moves) {
        const bool goes_on = motions.empty() && !drag.via.empty();
        const Vec3& at = goes_on ? drag.via.back() : move.from;
        motions.push_back({move.to - at, turn_of(move).jacobian()});
    }
    return motions;
}

// The zones and their mirror images with symmetry, which may differ by rounding: a face that only
// just meets a zone has its mirror image among the faces that follow, too.
std::vector<Box> both_sides(std::vector<Box> zones, const std::optional<MirrorPlane>& symmetry) {
    if (!symmetry) return zones;
    const std::size_t count = zones.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Box image = symmetry->image(zones[i]);
        if (std::ranges::find(zones, image) == zones.end()) zones.push_back(image);
    }
    return zones;
}

// Why intersections are left, and what helps.
std::string reason_of(CutLimit limit) {
    switch (limit) {
        case CutLimit::floor:
            return "since the floor keeps the edges there from being split; lower the floor";
        case CutLimit::budget:
            return "since the triangle budget is used up; raise the budget";
        case CutLimit::thinning:
            return "since without a flatness limit vertices there were removed; set flatness";
        case CutLimit::search:
        case CutLimit::none:
            break;
    }
    return "since there are too many to find them all; take a larger radius";
}

std::string remark_on_cuts(const Frame& frame) {
    if (frame.cuts == 0) return {};
    return "triangles still intersect each other in " + std::to_string(frame.cuts) +
           (frame.cuts == 1 ? " place, " : " places, ") + reason_of(frame.cut_limit) +
           ", or undo and drag less far";
}

}  // namespace

DragPlan Session::State::plan_of(const command::Drag& drag) const {
    DragPlan plan{.moves = {},
                  .pins = drag.pins,
                  .via = drag.via,
                  .fold_free = drag.fold_free,
                  .plane = symmetry,
                  .lattice = lattice_settings.lattice(drag.moves.front().from, diagonal),
                  .follows_point = !lattice_settings.cage.has_value()};
    for (const auto& move : drag.moves) plan.moves.push_back({move.from, move.to, turn_of(move)});
    return plan;
}

Refusal Session::State::check_lattice(const Lattice& lattice) const {
    const Vec3 extent = lattice.influenced_zone().extent();
    if (!lattice.is_valid() || !is_finite(extent)) {
        return "the lattice has no usable size (radius or cells of 0, or beyond numbers); set the "
               "brush radius or the cage to about the size of what is to move";
    }
    const double most = kLargestLattice * (diagonal + largest_coordinate);
    if (most == 0.0 || glm::length(extent) <= most) return std::nullopt;
    return "the lattice is more than a million times as large as the object; set the brush radius "
           "or the cage to about the size of what is to move";
}

Refusal Session::State::check_targets(const command::Drag& drag, double reach) const {
    const double most = kLargestDrag * (diagonal + reach);
    const auto check = [&](const Vec3& from, const Vec3& to) -> Refusal {
        if (glm::length(to - from) <= most) return std::nullopt;
        return "the drag from " + decimal(from) + " to " + decimal(to) +
               " goes more than a million times the size of the object; the most is " +
               decimal(most);
    };
    for (const command::Drag::Move& move : drag.moves) {
        if (Refusal refusal = check(move.from, move.to)) return refusal;
    }
    for (const Vec3& waypoint : drag.via) {
        if (Refusal refusal = check(drag.moves.front().from, waypoint)) return refusal;
    }
    return std::nullopt;
}

// The faces that follow: all that meet the zones, or the part that hangs together with the points.
std::variant<std::vector<FaceId>, std::string> Session::State::faces_of(
    const command::Drag& drag, std::span<const Box> zones) {
    std::vector<FaceId> faces;
    for (const Box& zone : zones) {
        const std::vector<FaceId> there = face_tree().faces_meeting(zone, *mesh);
        faces.insert(faces.end(), there.begin(), there.end());
    }
    if (zones.size() > 1) {
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    if (!drag.connected) return faces;
    std::vector<FaceId> seeds;
    for (const command::Drag::Move& move : drag.moves) {
        if (const auto face = face_tree().nearest(move.from, *mesh)) seeds.push_back(*face);
        if (!symmetry) continue;
        const auto opposite = face_tree().nearest(symmetry->image(move.from), *mesh);
        if (opposite) seeds.push_back(*opposite);
    }
    std::vector<FaceId> part = connected_part(*mesh, faces, seeds, zones);
    if (part.empty()) {
        return "the surface nearest to " + decimal(drag.moves.front().from) +
               " does not reach into the influenced zone; drag a point of the surface, or without "
               "connected";
    }
    return part;
}

// The vertices that are dragged or pinned, on both sides of the plane with symmetry; points between
// vertices have none.
std::vector<VertexId> Session::State::vertices_at_handles(const command::Drag& drag) {
    std::vector<Vec3> points = drag.pins;
    for (const auto& move : drag.moves) points.push_back(move.from);
    if (symmetry) {
        const std::size_t count = points.size();
        for (std::size_t i = 0; i < count; ++i) points.push_back(symmetry->image(points[i]));
    }
    std::vector<VertexId> vertices;
    for (const Vec3& point : points) {
        const auto face = face_tree().nearest(point, *mesh);
        for (int corner = 0; face && corner < 3; ++corner) {
            const VertexId v = mesh->origin(TriMesh::half_edge(*face, corner));
            const double most = kSamePoint * largest_component(point);
            if (glm::distance(mesh->position(v), point) <= most) vertices.push_back(v);
        }
    }
    return vertices;
}

void Session::State::start_gesture(InHand& begun, std::span<const FaceId> faces, Warp warp) {
    std::optional<AdaptLimits> adapt_limits;
    begun.lattice = lattice_of(warp.steps.back());
    if (adapt_settings.enabled) {
        adapt_limits = limits(begun.lattice);
        adapt_limits->without_cuts = begun.drag.fold_free;
    }
    begun.measured.steps = warp.steps.size();
    begun.gesture = std::make_unique<Gesture>(*active, faces, std::move(warp), adapt_limits,
                                              vertices_at_handles(begun.drag));
    begun.measured.influenced_vertices = begun.gesture->influenced_vertices();
}

// Plans the drag and begins its gesture, in place of the one there may be.
Refusal Session::State::embed(InHand& begun) {
    Stopwatch stopwatch;
    auto result = plan_drag(plan_of(begun.drag));
    if (auto* refusal = std::get_if<DragRefusal>(&result)) return std::move(refusal->what);
    PlannedDrag planned = std::move(std::get<PlannedDrag>(result));
    const std::size_t left = planned.warp.steps.size() - planned.last_segment;
    const bool is_alone = begun.drag.moves.size() == 1 && !turns(begun.drag.moves.front());
    begun.is_one_step_left = left == 1;
    if (begun.gesture && left > 1 && is_alone) {
        // Its steps become waypoints, so that the next frame has but the last to change.
        begun.drag.via.insert(begun.drag.via.end(),
                              planned.points.end() - static_cast<std::ptrdiff_t>(left - 1),
                              planned.points.end());
        begun.is_one_step_left = true;
    }
    begun.guard = begun.drag.fold_free ? std::make_unique<FoldGuard>(planned.last) : nullptr;
    begun.solver.emplace(std::move(planned.last));
    begun.measured.seconds.solve = stopwatch.lap();

    // At rest again: faces are looked for and embedded there.
    if (begun.gesture) {
        if (const auto changed = begun.gesture->cancel()) {
            show(*changed);
        } else {
            follow_everything();
        }
        begun.gesture.reset();
    }
    auto faces = faces_of(begun.drag, both_sides(planned.warp.zones(), symmetry));
    if (auto* refusal = std::get_if<std::string>(&faces)) return std::move(*refusal);
    // What throws from here on (memory) leaves no gesture, and the object at rest.
    start_gesture(begun, std::get<0>(faces), std::move(planned.warp));
    begun.measured.seconds.begin = stopwatch.lap();
    return std::nullopt;
}

Refusal Session::State::begin_drag(const command::Drag& drag) {
    assert(!in_hand);
    if (!has_object()) return kNoObject;
    if (drag.moves.empty()) return "a drag needs at least one move, from a point to another";
    const Lattice lattice = lattice_settings.lattice(drag.moves.front().from, diagonal);
    if (Refusal refusal = check_lattice(lattice)) return refusal;
    auto begun = std::make_unique<InHand>();
    begun->drag = drag;
    begun->reach = lattice.influenced_zone().diagonal();
    if (Refusal refusal = check_targets(drag, begun->reach)) return refusal;
    if (Refusal refusal = embed(*begun)) return refusal;
    in_hand = std::move(begun);
    return std::nullopt;
}

// Whether the last step takes everything there by itself; a refusal where nothing would.
bool Session::State::is_single_step(const command::Drag& drag, Refusal& refusal) const {
    const command::Drag& before = in_hand->drag;
    if (!in_hand->is_one_step_left) return false;
    for (std::size_t m = 0; m < drag.moves.size(); ++m) {
        if (turns(drag.moves[m]) != turns(before.moves[m])) return false;
        if (drag.fold_free && turn_of(drag.moves[m]).least_steps() > 1) return false;
    }
    const auto motions = last_motions(drag);
    if (const auto refused = check_drag(plan_of(drag))) {
        refusal = refused->what;
        return true;
    }
    if (const auto refused = in_hand->solver->check(motions)) {
        refusal = refused->what;
        return true;
    }
    return !in_hand->guard || in_hand->guard->limit(in_hand->solver->step(motions)) >= 1.0;
}

// Whether the last step has used up half of what it could.
bool Session::State::is_past_half_way() const {
    DragStep step = in_hand->solver->step(last_motions(in_hand->drag));
    for (Vec3& d : step.displacements) d *= 2.0;
    return in_hand->is_one_step_left && in_hand->guard->limit(step) < 1.0;
}

Refusal Session::State::drag_to(const command::Drag& asked) {
    assert(in_hand && in_hand->gesture && !in_hand->is_control());
    if (Refusal refusal = check_targets(asked, in_hand->reach)) return refusal;
    Refusal refusal;
    if (!is_single_step(asked, refusal)) {
        InHand next{.drag = asked, .reach = in_hand->reach, .measured = in_hand->measured};
        if (asked.fold_free && asked.moves.size() == 1 && is_past_half_way()) {
            next.drag.via.push_back(in_hand->drag.moves.front().to);
        }
        // Where the plan is refused the present one stays.
        next.gesture = std::move(in_hand->gesture);
        refusal = embed(next);
        if (refusal && next.gesture) {
            in_hand->gesture = std::move(next.gesture);
            return refusal;
        }
        *in_hand = std::move(next);
    }
    if (refusal) return refusal;
    in_hand->drag.moves = asked.moves;
    show_frame(last_displacements());
    return std::nullopt;
}

// What the last step of the warp is displaced by: where it is all of the last segment, by what the
// drag asks for now, else by what was planned.
std::vector<Vec3> Session::State::last_displacements() const {
    const Warp::Step& last_step = in_hand->gesture->warp().steps.back();
    if (!in_hand->is_one_step_left) {
        const std::span<const Vec3> planned = displacements_of(last_step);
        return {planned.begin(), planned.end()};
    }
    const auto motions = last_motions(in_hand->drag);
    if (std::holds_alternative<DragStep>(last_step)) {
        return in_hand->solver->field_displacements(motions);
    }
    const Warp::Step step = compact(in_hand->solver->step(motions));
    const std::span<const Vec3> asked = displacements_of(step);
    return {asked.begin(), asked.end()};
}

void Session::State::show_frame(std::span<const Vec3> displacements) {
    in_hand->gesture->frame(displacements);
    // Corners of new faces may lie where nothing moves: they are shown with their faces.
    show(in_hand->gesture->take_edited_faces());
    if (dirty.everything) return;
    // At least one a vertex; what was named before has its room already.
    if (dirty.wedges.empty()) dirty.wedges.reserve(in_hand->gesture->influenced_vertices());
    in_hand->gesture->append_moved_wedges(dirty.wedges);
}

// Cancels where nothing moves: such a gesture does nothing.
void Session::State::commit(std::span<const Vec3> displacements, bool is_nothing) {
    last = in_hand->measured;
    if (is_nothing) {
        cancel_drag();
        return;
    }
    Stopwatch stopwatch;
    MeshChange change = in_hand->gesture->commit(displacements);
    try {
        finish_commit(change);
    } catch (...) {  // no memory: the object as it was
        undo(change, *mesh);
        follow_everything();
        take_outcome();
        in_hand.reset();
        throw;
    }
    last.seconds.commit =
        stopwatch.lap() - last.seconds.deform - last.seconds.refine - last.seconds.decimate;
}

// Makes what the gesture in hand has done a step of the history. All that can fail for want of
// memory comes first.
void Session::State::finish_commit(MeshChange& change) {
    const Gesture& gesture = *in_hand->gesture;
    // What frames have shown and the commit has taken back is shown anew, too.
    show(in_hand->gesture->take_edited_faces());
    std::vector<Box> zones = gesture.warp().zones();
    std::string told = remark_on_cuts(gesture.last_frame());
    note(gesture.last_frame());
    add_step(in_hand->is_control() ? Command{in_hand->control} : Command{in_hand->drag}, change);

    lattice_in_use = in_hand->lattice;
    zones_in_use = std::move(zones);
    // Other parts reach into the zones, too, but were not refined there.
    if (in_hand->drag.connected) zones_in_use.clear();
    remark = std::move(told);
    folded = gesture.folded_vertices();
    in_hand.reset();
}

std::optional<command::Drag> Session::State::end_drag() {
    assert(in_hand && in_hand->gesture && !in_hand->is_control());
    std::optional<command::Drag> drag = in_hand->drag;  // a copy later could fail after the step
    const bool is_nothing = moves_nothing(*drag);
    commit(last_displacements(), is_nothing);
    if (is_nothing) drag.reset();
    return drag;
}

void Session::State::cancel_drag() noexcept {
    assert(in_hand);
    const std::unique_ptr<InHand> cancelled = std::move(in_hand);
    if (!cancelled->gesture) {  // rolled back where memory gave out, and nobody was told
        follow_everything();
        return;
    }
    if (const auto changed = cancelled->gesture->cancel()) {
        follow(*changed);
    } else {
        follow_everything();
    }
}

Refusal Session::State::run(const command::Drag& drag) {
    if (Refusal refusal = begin_drag(drag)) return refusal;
    try {
        end_drag();
    } catch (...) {
        if (in_hand) cancel_drag();
        throw;
    }
    return std::nullopt;
}

}  // namespace pectin

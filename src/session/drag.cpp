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

Rotation rotation_of(const command::Drag::Move& move) {
    Rotation rotation{.scale = move.scale};
    if (move.twist) {
        rotation.axis = move.twist->axis;
        rotation.degrees = move.twist->degrees;
    }
    return rotation;
}

bool rotates(const command::Drag::Move& move) { return !rotation_of(move).is_none(); }

bool has_no_effect(const command::Drag& drag) {
    const bool stays_in_place =
        std::all_of(drag.moves.begin(), drag.moves.end(),
                    [](const auto& move) { return move.to == move.from && !rotates(move); });
    return stays_in_place && std::all_of(drag.via.begin(), drag.via.end(), [&](const Vec3& point) {
               return point == drag.moves.front().from;
           });
}

// What the last step is asked for where it makes up the last segment.
std::vector<HandleMotion> last_motions(const command::Drag& drag) {
    std::vector<HandleMotion> motions;
    for (const auto& move : drag.moves) {
        const bool continues = motions.empty() && !drag.via.empty();
        const Vec3& at = continues ? drag.via.back() : move.from;
        motions.push_back({move.to - at, rotation_of(move).jacobian()});
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
std::string reason_of(IntersectionLimit limit) {
    switch (limit) {
        case IntersectionLimit::floor:
            return "since the floor keeps the edges there from being split; lower the floor";
        case IntersectionLimit::budget:
            return "since the triangle budget is used up; raise the budget";
        case IntersectionLimit::decimation:
            return "since without a flatness limit vertices there were removed; set flatness";
        case IntersectionLimit::search:
        case IntersectionLimit::none:
            break;
    }
    return "since there are too many to find them all; take a larger radius";
}

std::string remark_on_self_intersections(const Frame& frame) {
    if (frame.self_intersections == 0) return {};
    return "triangles still intersect each other in " + std::to_string(frame.self_intersections) +
           (frame.self_intersections == 1 ? " place, " : " places, ") +
           reason_of(frame.intersection_limit) + ", or undo and drag less far";
}

}  // namespace

DragPlan Session::State::plan_of(const command::Drag& drag) const {
    DragPlan plan{.moves = {},
                  .pins = drag.pins,
                  .via = drag.via,
                  .fold_free = drag.fold_free,
                  .plane = symmetry,
                  .lattice = lattice_settings.lattice(drag.moves.front().from, diagonal),
                  .is_centred_on_point = !lattice_settings.cage.has_value()};
    for (const auto& move : drag.moves)
        plan.moves.push_back({move.from, move.to, rotation_of(move)});
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

void Session::State::start_gesture(ActiveGesture& begun, std::span<const FaceId> faces, Warp warp) {
    std::optional<AdaptLimits> adapt_limits;
    begun.lattice = lattice_of(warp.steps.back());
    if (adapt_settings.enabled) {
        adapt_limits = limits(begun.lattice);
        adapt_limits->without_self_intersections = begun.drag.fold_free;
    }
    begun.measured.steps = warp.steps.size();
    begun.gesture = std::make_unique<Gesture>(*active, faces, std::move(warp), adapt_limits,
                                              vertices_at_handles(begun.drag));
    begun.measured.influenced_vertices = begun.gesture->influenced_vertices();
}

// Plans the drag and begins its gesture, in place of the one there may be.
Refusal Session::State::embed(ActiveGesture& begun) {
    Stopwatch stopwatch;
    auto result = plan_drag(plan_of(begun.drag));
    if (auto* refusal = std::get_if<DragRefusal>(&result)) return std::move(refusal->what);
    PlannedDrag planned = std::move(std::get<PlannedDrag>(result));
    const std::size_t left = planned.warp.steps.size() - planned.last_segment;
    const bool is_alone = begun.drag.moves.size() == 1 && !rotates(begun.drag.moves.front());
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
            mark_dirty(*changed);
        } else {
            update_everything();
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
    assert(!active_gesture);
    if (!has_object()) return kNoObject;
    if (drag.moves.empty()) return "a drag needs at least one move, from a point to another";
    const Lattice lattice = lattice_settings.lattice(drag.moves.front().from, diagonal);
    if (Refusal refusal = check_lattice(lattice)) return refusal;
    auto begun = std::make_unique<ActiveGesture>();
    begun->drag = drag;
    begun->reach = lattice.influenced_zone().diagonal();
    if (Refusal refusal = check_targets(drag, begun->reach)) return refusal;
    if (Refusal refusal = embed(*begun)) return refusal;
    active_gesture = std::move(begun);
    return std::nullopt;
}

// Whether the last step takes everything there by itself; a refusal where nothing would.
bool Session::State::is_single_step(const command::Drag& drag, Refusal& refusal) const {
    const command::Drag& before = active_gesture->drag;
    if (!active_gesture->is_one_step_left) return false;
    for (std::size_t m = 0; m < drag.moves.size(); ++m) {
        if (rotates(drag.moves[m]) != rotates(before.moves[m])) return false;
        if (drag.fold_free && rotation_of(drag.moves[m]).least_steps() > 1) return false;
    }
    const auto motions = last_motions(drag);
    if (const auto refused = check_drag(plan_of(drag))) {
        refusal = refused->what;
        return true;
    }
    if (const auto refused = active_gesture->solver->check(motions)) {
        refusal = refused->what;
        return true;
    }
    return !active_gesture->guard ||
           active_gesture->guard->limit(active_gesture->solver->step(motions)) >= 1.0;
}

// Whether the last step has used up half of what it could.
bool Session::State::is_past_half_way() const {
    DragStep step = active_gesture->solver->step(last_motions(active_gesture->drag));
    for (Vec3& d : step.displacements) d *= 2.0;
    return active_gesture->is_one_step_left && active_gesture->guard->limit(step) < 1.0;
}

Refusal Session::State::drag_to(const command::Drag& asked) {
    assert(active_gesture && active_gesture->gesture && !active_gesture->is_control());
    if (Refusal refusal = check_targets(asked, active_gesture->reach)) return refusal;
    Refusal refusal;
    if (!is_single_step(asked, refusal)) {
        ActiveGesture next{
            .drag = asked, .reach = active_gesture->reach, .measured = active_gesture->measured};
        if (asked.fold_free && asked.moves.size() == 1 && is_past_half_way()) {
            next.drag.via.push_back(active_gesture->drag.moves.front().to);
        }
        // Where the plan is refused the present one stays.
        next.gesture = std::move(active_gesture->gesture);
        refusal = embed(next);
        if (refusal && next.gesture) {
            active_gesture->gesture = std::move(next.gesture);
            return refusal;
        }
        *active_gesture = std::move(next);
    }
    if (refusal) return refusal;
    active_gesture->drag.moves = asked.moves;
    update_frame(last_displacements());
    return std::nullopt;
}

// What the last step of the warp is displaced by: where it is all of the last segment, by what the
// drag asks for now, else by what was planned.
std::vector<Vec3> Session::State::last_displacements() const {
    const Warp::Step& last_step = active_gesture->gesture->warp().steps.back();
    if (!active_gesture->is_one_step_left) {
        const std::span<const Vec3> planned = displacements_of(last_step);
        return {planned.begin(), planned.end()};
    }
    const auto motions = last_motions(active_gesture->drag);
    if (std::holds_alternative<DragStep>(last_step)) {
        return active_gesture->solver->field_displacements(motions);
    }
    const Warp::Step step = compact(active_gesture->solver->step(motions));
    const std::span<const Vec3> asked = displacements_of(step);
    return {asked.begin(), asked.end()};
}

void Session::State::update_frame(std::span<const Vec3> displacements) {
    active_gesture->gesture->frame(displacements);
    // Corners of new faces may lie where nothing moves: they are shown with their faces.
    mark_dirty(active_gesture->gesture->take_edited_faces());
    if (dirty.everything) return;
    // At least one a vertex; what was named before has its room already.
    if (dirty.wedges.empty()) dirty.wedges.reserve(active_gesture->gesture->influenced_vertices());
    active_gesture->gesture->append_moved_wedges(dirty.wedges);
}

// Cancels where nothing moves: such a gesture does nothing.
void Session::State::commit(std::span<const Vec3> displacements, bool is_noop) {
    last = active_gesture->measured;
    if (is_noop) {
        cancel_drag();
        return;
    }
    Stopwatch stopwatch;
    MeshChange change = active_gesture->gesture->commit(displacements);
    try {
        finish_commit(change);
    } catch (...) {  // no memory: the object as it was
        undo(change, *mesh);
        update_everything();
        take_outcome();
        active_gesture.reset();
        throw;
    }
    last.seconds.commit =
        stopwatch.lap() - last.seconds.deform - last.seconds.refine - last.seconds.decimate;
}

// Makes what the gesture in hand has done a step of the history. All that can fail for want of
// memory comes first.
void Session::State::finish_commit(MeshChange& change) {
    const Gesture& gesture = *active_gesture->gesture;
    // What frames have shown and the commit has taken back is shown anew, too.
    mark_dirty(active_gesture->gesture->take_edited_faces());
    std::vector<Box> zones = gesture.warp().zones();
    std::string message = remark_on_self_intersections(gesture.last_frame());
    record(gesture.last_frame());
    add_step(active_gesture->is_control() ? Command{active_gesture->control}
                                          : Command{active_gesture->drag},
             change);

    lattice_in_use = active_gesture->lattice;
    zones_in_use = std::move(zones);
    // Other parts reach into the zones, too, but were not refined there.
    if (active_gesture->drag.connected) zones_in_use.clear();
    remark = std::move(message);
    folded = gesture.folded_vertices();
    active_gesture.reset();
}

std::optional<command::Drag> Session::State::end_drag() {
    assert(active_gesture && active_gesture->gesture && !active_gesture->is_control());
    // Copied before the step is done: a copy afterwards could fail.
    std::optional<command::Drag> drag = active_gesture->drag;
    const bool is_noop = has_no_effect(*drag);
    commit(last_displacements(), is_noop);
    if (is_noop) drag.reset();
    return drag;
}

void Session::State::cancel_drag() noexcept {
    assert(active_gesture);
    const std::unique_ptr<ActiveGesture> cancelled = std::move(active_gesture);
    if (!cancelled->gesture) {  // rolled back where memory gave out, and nobody was told
        update_everything();
        return;
    }
    if (const auto changed = cancelled->gesture->cancel()) {
        update_faces(*changed);
    } else {
        update_everything();
    }
}

Refusal Session::State::run(const command::Drag& drag) {
    if (Refusal refusal = begin_drag(drag)) return refusal;
    try {
        end_drag();
    } catch (...) {
        if (active_gesture) cancel_drag();
        throw;
    }
    return std::nullopt;
}

}  // namespace pectin

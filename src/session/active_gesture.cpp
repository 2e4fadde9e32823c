// The active gesture, of a drag or of control points: its beginning, frames, commit and cancelling.
#include <cassert>
#include <string>
#include <utility>

#include "session/session_state.h"

namespace pectin {
namespace {

// Why intersections remain, where it is not the drag itself.
std::string reason_of(const Frame& frame) {
    switch (frame.intersection_limit) {
        case IntersectionLimit::budget:
            return frame.drag_budget_hit ? ", since the triangle budget of the drag is used up"
                                         : ", since the triangle budget is used up";
        case IntersectionLimit::decimation:
            return ", since without a flatness limit vertices there were removed";
        case IntersectionLimit::floor:
        case IntersectionLimit::search:
        case IntersectionLimit::none:
            break;
    }
    return "";
}

std::string remark_on_self_intersections(const Frame& frame) {
    if (frame.self_intersections == 0) {
        if (frame.intersection_limit != IntersectionLimit::search) return {};
        return "so many triangles are close to each other that some may intersect; undo, or use a "
               "larger radius or a shorter drag";
    }
    // A search that was ended early has found only some of them.
    return std::string("the surface intersects itself in ") +
           (frame.intersection_limit == IntersectionLimit::search ? "at least " : "") +
           std::to_string(frame.self_intersections) +
           (frame.self_intersections == 1 ? " place" : " places") + reason_of(frame) +
           "; undo, or use a larger radius or a shorter drag";
}

std::string remark_on_drag_budget(const Frame& frame) {
    if (!frame.drag_budget_hit) return {};
    return "the surface is coarser than the detail asks for, since the triangle budget of the drag "
           "is used up; undo and drag less far, or choose a coarser detail or a larger budget";
}

// are_in_zones: without `connected` the drag would move the faces, too.
std::string remark_on_passed_faces(const PassedFaces& passed, bool are_in_zones) {
    const std::size_t count = passed.faces.size();
    if (count == 0 && !passed.are_all) {
        return "there are too many triangles to find out whether the part that was dragged passes "
               "through a part that stays";
    }
    if (count == 0) return {};
    return std::string("the part that was dragged passes through ") +
           (passed.are_all ? "" : "at least ") +
           (count == 1 ? "a triangle" : std::to_string(count) + " triangles") +
           " of a part that stays; undo and drag less far" +
           (are_in_zones ? ", or switch connected off" : "");
}

std::string joined(std::string first, const std::string& second) {
    if (!first.empty() && !second.empty()) first += "; ";
    return first + second;
}

}  // namespace

void Session::State::start_gesture(ActiveGesture& begun, const GestureFaces& faces, Warp warp) {
    std::optional<Gesture::Adaptivity> adaptivity;
    begun.lattice = lattice_of(warp.steps.back());
    if (adapt_settings.enabled) {
        const auto drag_budget = adapt_settings.drag_budget_for(faces.moving.size());
        adaptivity = {.limits = drag_limits(smallest_feature_extent(warp.steps.back())),
                      .drag_budget = drag_budget.value_or(Gesture::kNoBudget),
                      .kept = vertices_at_handles(begun.drag)};
        adaptivity->limits.without_self_intersections = begun.drag.fold_free;
    }
    begun.measured.steps = warp.steps.size();
    begun.gesture =
        std::make_unique<Gesture>(*active, faces, std::move(warp), std::move(adaptivity), stop);
    begun.measured.influenced_vertices = begun.gesture->influenced_vertices();
}

void Session::State::update_frame(std::span<const Vec3> displacements) {
    active_gesture->gesture->frame(displacements, frame_time);
    // The corners of new faces may lie where nothing moves, so they are marked with their faces.
    mark_dirty(active_gesture->gesture->take_edited_faces());
    if (dirty.everything) return;
    active_gesture->gesture->append_moved_wedges(dirty.wedges);
}

// Without a gesture memory has run out, or a new plan was refused.
bool Session::State::has_unfinished_frame() const {
    return active_gesture && active_gesture->gesture &&
           !active_gesture->gesture->last_frame().is_complete;
}

bool Session::State::continue_frame() {
    if (!has_unfinished_frame()) return false;
    const Gesture& gesture = *active_gesture->gesture;
    const std::span<const Vec3> now = displacements_of(gesture.warp().steps.back());
    update_frame(std::vector<Vec3>(now.begin(), now.end()));
    return true;
}

// A gesture in which nothing moves is cancelled.
void Session::State::commit(std::span<const Vec3> displacements, bool is_noop) {
    last = active_gesture->measured;
    if (is_noop) {
        cancel_drag();
        return;
    }
    Stopwatch stopwatch;
    active_gesture->gesture->return_to_rest();
    const SearchedFaces searched{.surroundings = surroundings(),
                                 .staying = staying_faces(displacements)};
    MeshChange change = active_gesture->gesture->commit(displacements, searched, stop);
    try {
        finish_commit(change);
    } catch (...) {  // out of memory: restores the object
        undo(change, *mesh);
        update_everything();
        outcome = history.outcome();
        active_gesture.reset();
        throw;
    }
    last.seconds.commit =
        stopwatch.lap() - last.seconds.deform - last.seconds.refine - last.seconds.decimate;
}

// Makes the change a step of the history. Everything that may run out of memory comes first.
void Session::State::finish_commit(MeshChange& change) {
    const Gesture& gesture = *active_gesture->gesture;
    // The commit has rolled back edits that frames have shown, so they are drawn again, too.
    mark_dirty(active_gesture->gesture->take_edited_faces());
    // Of a connected drag, other parts of the surface reach into the zones, but they were not
    // refined there.
    const bool limits_edge_length = gesture.limits_edge_length() && !active_gesture->drag.connected;
    std::vector<Box> zones = limits_edge_length ? gesture.warp().zones() : std::vector<Box>{};
    const Frame& frame = gesture.last_frame();
    std::string message = joined(remark_on_drag_budget(frame), remark_on_self_intersections(frame));
    message = joined(std::move(message),
                     remark_on_passed_faces(frame.passed, !active_gesture->staying.empty()));
    record(gesture.last_frame());
    add_step(active_gesture->is_control() ? Command{active_gesture->control}
                                          : Command{active_gesture->drag},
             change);

    lattice_in_use = active_gesture->lattice;
    zones_in_use = std::move(zones);
    remark = std::move(message);
    folded = gesture.folded_vertices();
    active_gesture.reset();
}

void Session::State::cancel_drag() noexcept {
    assert(active_gesture);
    const std::unique_ptr<ActiveGesture> cancelled = std::move(active_gesture);
    if (!cancelled->gesture) {  // memory ran out, and the rollback has not marked anything
        update_everything();
        return;
    }
    if (const auto changed = cancelled->gesture->cancel()) {
        update_faces(*changed);
    } else {
        update_everything();
    }
}

}  // namespace pectin

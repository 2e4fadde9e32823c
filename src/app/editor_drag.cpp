// How an Editor drags points of the object and control points of the cage, and sets pins.
#include <chrono>
#include <cmath>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "app/cursor_path.h"
#include "app/editor.h"
#include "app/execute.h"
#include "app/rounded_numbers.h"

namespace pectin {
namespace {

// Deviations of the cursor's path by fewer pixels are not meant by the user.
constexpr double kPathTolerance = 4.0;
// A grabbed point within this many pixels of the plane of symmetry is moved onto it. It could
// hardly be moved apart from its image otherwise, since the two would be nearly one constraint.
constexpr double kSnapDistance = 8.0;
constexpr double kDegreesPerNotch = 5.0;

}  // namespace

// Runs a part of a drag. If it throws, the drag is cancelled. Returns whether it did not throw.
template <typename Part>
bool Editor::attempt(Part part) {
    try {
        part();
        return true;
    } catch (const std::bad_alloc&) {
        handle_out_of_memory("drag");
    } catch (const std::exception& error) {
        abandon_drag();
        workspace_.set_message(std::string("The drag was cancelled: ") + error.what());
    }
    return false;
}

// Cancels the active drag, if any. The session may no longer have it: then its end has failed.
void Editor::abandon_drag() noexcept {
    if (session().is_dragging()) return cancel_drag();
    sculptor_.end();
    if (cage_points_.is_dragging()) cage_points_.end_drag();
    drag_is_stale_ = false;
}

void Editor::handle_out_of_memory(const char* what) noexcept {
    if (workspace_.edit_task()) return;  // the session, also its history, is in use
    abandon_drag();
    try {
        workspace_.set_message(not_enough_memory(what, session().history()));
    } catch (const std::bad_alloc&) {
        // There is not even enough memory for the message.
    }
}

void Editor::press_on_surface(const Vec2& at, const Pick& pick) {
    if (sets_pins) return toggle_pin();
    attempt([&] { grab(handle_at(pick, at), view().ray_through(at)); });
}

// Returns what a press at the cursor grabs: the pin whose marker is there, or the surface point.
Pick Editor::handle_at(Pick pick, const Vec2& at) const {
    const auto marker = pins_.at(view(), at, pick, session().symmetry());
    if (!marker) return snapped_to_symmetry_plane(pick);
    pick.point = marker->position;
    return pick;
}

Pick Editor::snapped_to_symmetry_plane(Pick pick) const {
    const auto& plane = session().symmetry();
    const double reach = kSnapDistance * view().pixel_length(pick.point);
    if (plane && std::abs(plane->offset(pick.point)) < reach) pick.point = plane->onto(pick.point);
    return pick;
}

void Editor::grab(const Pick& pick, const Ray& ray) {
    const Done done = sculptor_.grab(workspace_.session(), pick, ray, pins_.points(), drag_options);
    if (!done) return workspace_.set_message(rounded_numbers(done.refusal().reason));
    workspace_.clear_command_message();
    shows_hint_ = false;
    hover_.reset();
    drag_is_stale_ = false;
    cursor_path_.clear();
    last_cursor_ = cursor_;
    reset_figures();
}

void Editor::drag() {
    attempt([&] {
        if (sculptor_.is_dragging()) {
            update_point_drag();
        } else {
            update_control_drag();
        }
    });
}

bool Editor::has_unfinished_frame() const {
    return !is_working() && session().has_unfinished_frame();
}

// Goes on with adaptive meshing for which the frame before had no time left.
void Editor::continue_frame() {
    if (!has_unfinished_frame()) return;
    attempt([&] {
        const auto start = std::chrono::steady_clock::now();
        const FrameFigures before = figures_;
        workspace_.session().continue_frame();
        record_frame(std::chrono::steady_clock::now() - start);
        figures_.splits += before.splits;
        figures_.unsplits += before.unsplits;
    });
}

// The steps of a fold-free drag depend on the path, so such a drag follows the cursor's path.
void Editor::update_point_drag() {
    const auto start = std::chrono::steady_clock::now();
    const DragPath path = modifiers_.alt ? DragPath::normal : DragPath::view_plane;
    std::vector<Vec2> positions{cursor_};
    if (drag_options.fold_free && !cursor_path_.empty()) {
        positions = simplified_path(last_cursor_, cursor_path_, kPathTolerance);
    }
    cursor_path_.clear();
    last_cursor_ = cursor_;
    const command::Drag before = session().active_drag();
    Done done;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        // Only the last position is shown.
        workspace_.limit_frame_time(i + 1 == positions.size());
        done =
            sculptor_.drag(workspace_.session(), camera(), view().ray_through(positions[i]), path);
    }
    if (!done) return workspace_.set_message(rounded_numbers(done.refusal().reason));
    workspace_.clear_command_message();
    if (session().active_drag() == before) return;
    record_frame(std::chrono::steady_clock::now() - start);
    figures_.steps = session().active_drag().via.size() + 1;
    figures_.degrees = sculptor_.degrees();
    figures_.scale = sculptor_.scale();
}

void Editor::update_control_drag() {
    const auto start = std::chrono::steady_clock::now();
    const bool had_begun = cage_points_.is_dragging();
    workspace_.limit_frame_time(true);  // a drag of a point may have ended in between
    const Done done = cage_points_.update_drag(workspace_.session(), view());
    if (!done) return workspace_.set_message(rounded_numbers(done.refusal().reason));
    if (!cage_points_.is_dragging()) return;
    if (!had_begun) reset_figures();
    workspace_.clear_command_message();
    shows_hint_ = false;
    record_frame(std::chrono::steady_clock::now() - start);
}

void Editor::reset_figures() {
    figures_.steps = 1;
    figures_.degrees = 0.0;
    figures_.scale = 1.0;
    figures_.folded = 0;
}

void Editor::record_frame(std::chrono::duration<double> taken) {
    const Frame& frame = session().last_frame();
    figures_.splits = frame.splits;
    figures_.unsplits = frame.unsplits;
    figures_.seconds = taken.count();
    figures_.deform_seconds = frame.deform_seconds;
    figures_.refine_seconds = frame.refine_seconds;
    figures_.decimate_seconds = frame.decimate_seconds;
    figures_.floor_hit = frame.floor_hit;
    figures_.budget_hit = frame.budget_hit;
    figures_.drag_budget_hit = frame.drag_budget_hit;
}

void Editor::release_drag() {
    if (std::exchange(drag_is_stale_, false)) drag();
    if (session().is_dragging()) {
        attempt([&] { finish_drag(workspace_.end_drag()); });
    } else if (cage_points_.is_active()) {
        cage_points_.release(session(), view());
    }
}

void Editor::finish_drag(Workspace::Outcome outcome) {
    if (outcome == Workspace::Outcome::in_progress) return;
    abandon_drag();
    if (outcome == Workspace::Outcome::done && workspace_.has_moved()) report_drag();
    document_.continue_quitting();
}

void Editor::report_drag() {
    figures_.folded = session().folded_vertices();
    std::string message;
    if (figures_.folded > 0) {
        message = "This drag turned space inside out at " + std::to_string(figures_.folded) +
                  (figures_.folded == 1 ? " vertex" : " vertices") +
                  ". Undo it, or switch on Fold-free, which prevents this when the surface is "
                  "dragged.";
    }
    if (const std::string& remark = session().remark(); !remark.empty()) {
        message += (message.empty() ? "After this drag " : " After it ") + remark + ".";
    }
    if (!message.empty()) workspace_.set_message(message);
}

FrameFigures Editor::figures() const {
    FrameFigures figures = figures_;
    if (!sculptor_.is_dragging() && !cage_points_.is_dragging()) {
        const AdaptOutcome outcome = workspace_.object_figures().outcome;
        figures.floor_hit = outcome.floor_hit;
        figures.budget_hit = outcome.budget_hit;
        figures.drag_budget_hit = outcome.drag_budget_hit;
    }
    return figures;
}

void Editor::cancel_drag() {
    if (sculptor_.is_dragging()) sculptor_.cancel(workspace_.session());
    if (cage_points_.is_active()) cage_points_.cancel(workspace_.session());
    reset_figures();
    drag_is_stale_ = false;
}

void Editor::rotate_or_scale(double notches) {
    if (modifiers_.shift) {
        sculptor_.scale_by_steps(notches);
    } else {
        sculptor_.rotate(kDegreesPerNotch * notches);
    }
    drag_is_stale_ = true;
}

// --- Pins.

void Editor::toggle_pin() {
    if (!cursor_in_viewport_) return;
    std::optional<Pick> pick = workspace_.session().pick(view().ray_through(cursor_));
    if (pick) pick = snapped_to_symmetry_plane(*pick);
    if (pins_.toggle(view(), cursor_, pick, session().symmetry()))
        workspace_.clear_command_message();
}

}  // namespace pectin

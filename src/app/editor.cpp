#include "app/editor.h"

#include <algorithm>
#include <utility>

#include "app/picture.h"

namespace pectin {
namespace {

// Limits of the brush's radius, in diagonals of the object's box.
constexpr double kMinRadius = 1e-3, kMaxRadius = 2.0;
// The part of the window between the panels on both sides, centred in the window.
constexpr double kFreeWidth = 0.56, kFreeHeight = 0.78;

}  // namespace

Editor::Editor(std::optional<Recorder> recorder, std::chrono::milliseconds max_blocking_time)
    : workspace_(std::move(recorder), max_blocking_time) {
    frame_all(kFitDirection);
}

void Editor::advance() {
    if (restoration_) {
        continue_restoring();
    } else if (workspace_.is_working()) {
        poll_work();
    } else if (has_drag()) {
        if (std::exchange(drag_is_stale_, false)) {
            drag();
        } else {
            continue_frame();
        }
    }
    update_hover();
}

void Editor::poll_work() {
    const EditTask* const edit = workspace_.edit_task();
    if (edit && !edit->command()) return finish_drag(workspace_.poll());
    const Command command = edit ? *edit->command() : workspace_.file_task()->command;
    finish_command(command, workspace_.poll());
}

void Editor::update_hover() {
    // While the radius is being set, its circle stays where it is.
    if (has_drag() || radius_drag_) return;
    hover_.reset();
    std::optional<IVec3> control_point;
    cage_points_.reset_for(editable_cage());
    if (cursor_in_viewport_ && !navigation_.is_active() && !has_dialog()) {
        hover_ = workspace_.session().pick(view().ray_through(cursor_));
        if (editable_cage())
            control_point = cage_points_.find_at(session(), view(), cursor_, hover_);
    }
    cage_points_.set_hovered(control_point);
    if (control_point) hover_.reset();
}

// --- Radius.

double Editor::radius() const { return radius_drag_ ? radius_drag_->radius : workspace_.radius(); }
double Editor::min_radius() const { return kMinRadius * workspace_.diagonal(); }
double Editor::max_radius() const { return kMaxRadius * workspace_.diagonal(); }

void Editor::begin_radius_drag() {
    if (is_busy() || navigation_.is_active()) return;
    radius_drag_ = RadiusDrag{cursor_.x, workspace_.radius(), workspace_.radius()};
}

void Editor::end_radius_drag(bool keeps) {
    const RadiusDrag done = *std::exchange(radius_drag_, std::nullopt);
    if (keeps && done.radius != done.start_radius) set_radius(done.radius);
}

void Editor::set_radius(double radius) {
    execute(command::Brush{.radius = std::clamp(radius, min_radius(), max_radius())});
}

// --- Symmetry and cage.

command::Symmetry Editor::symmetry_command(bool is_on) const {
    command::Symmetry symmetry;
    if (is_on) {
        symmetry.plane = mirror_.plane;
        if (mirror_.through_centre) symmetry.through = workspace_.box().centre();
    }
    return symmetry;
}

void Editor::set_symmetry(bool is_on) { execute(symmetry_command(is_on)); }

void Editor::choose_mirror(const MirrorChoice& choice) {
    if (is_busy()) return;
    mirror_ = choice;
    if (session().symmetry()) set_symmetry(true);
}

void Editor::set_cage(const Box& box, const IVec3& counts) {
    const Lattice cage = fit_lattice(box, counts);
    execute(command::Cage{command::Cage::Grid{.origin = cage.rest(cage.margin),
                                              .cell = cage.cell,
                                              .deformable = cage.counts(),
                                              .margin = cage.margin}});
}

std::optional<Lattice> Editor::editable_cage() const {
    return display.lattice ? session().lattice_settings().cage : std::nullopt;
}

// --- Actions.

void Editor::perform(Action action) {
    const ActionInfo& info = info_of(action);
    if (!is_busy() && info.is_enabled(*this)) info.perform(*this);
}

void Editor::undo() {
    if (session().undo_count() > 0) {
        execute(command::Undo{});
    } else if (session().history().lost_undo_count() > 0) {
        workspace_.set_message(
            "There is nothing left to undo: older steps were dropped to limit memory. The limit is "
            "in the menu Edit, Memory for undo.");
    }
}

bool Editor::execute(const Command& command) {
    return !is_busy() && finish_command(command, workspace_.execute(command));
}

void Editor::new_shape(command::Shape::Kind kind, int resolution) {
    ask_or_do({command::Shape{kind, resolution}});
}

void Editor::quit() {
    if (is_working()) {
        cancel_work();
        quits_next_ = true;
    } else {
        ask_or_do({Question::Quit{}});
    }
}

void Editor::frame_all(const std::optional<Vec3>& direction) {
    const double aspect = kFreeWidth * size_.x / (kFreeHeight * size_.y);
    navigation_.frame(referenced_positions(session().mesh()), aspect, kFreeHeight, direction);
}

}  // namespace pectin

#include "app/editor.h"

#include <algorithm>
#include <utility>

#include "app/command_kind.h"
#include "app/picture.h"

namespace pectin {
namespace {

constexpr double kRadiusStep = 1.12;
// Limits of the brush's radius, in diagonals of the object's box.
constexpr double kMinRadius = 1e-3, kMaxRadius = 2.0;
// The part of the window between the panels on both sides, centred in the window.
constexpr double kFreeWidth = 0.56, kFreeHeight = 0.78;

}  // namespace

Editor::Editor(std::optional<Recorder> recorder, std::chrono::milliseconds max_blocking_time)
    : workspace_(std::move(recorder), max_blocking_time) {
    frame_all(kFitDirection);
}

void Editor::begin(const std::string& model) {
    if (!model.empty()) return document_.open(model);
    document_.make_first_object();
    set_symmetry(true);
}

void Editor::advance() {
    if (is_working()) {
        advance_work();
    } else if (has_drag()) {
        if (std::exchange(drag_is_stale_, false)) {
            drag();
        } else {
            continue_frame();
        }
    }
    update_hover();
}

void Editor::advance_work() {
    const EditTask* const edit = workspace_.edit_task();
    const bool is_end_of_drag = edit && !edit->command();
    if (is_end_of_drag) {
        finish_drag(workspace_.poll());
    } else {
        document_.advance();
    }
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

// --- For the document controller.

void Editor::command_done(const Command& command) {
    hover_.reset();
    if (makes_object(command)) reset_for_new_object();
    if (is_any_of<command::Undo, command::Redo>(command)) figures_.folded = 0;
}

// Discards what belonged to the object before.
void Editor::reset_for_new_object() {
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
    reset_sizes();
    // The plane follows the centre of the new object.
    if (session().symmetry() && mirror_.through_centre) {
        document_.execute_keeping_message(symmetry_command(true));
    }
}

// Sizes that were set for the object before may be wrong by orders of magnitude for this one.
void Editor::reset_sizes() {
    const LatticeSettings& lattice = session().lattice_settings();
    const double diagonal = workspace_.diagonal();
    if ((lattice.radius || lattice.cage) && diagonal > 0.0) {
        document_.execute_keeping_message(command::Brush{.radius = kAutoRadius * diagonal});
    }
    const AdaptSettings& adapt = session().adapt_settings();
    command::Adapt change;
    if (adapt.l_max.kind == Setting::Kind::value) change.l_max = Setting::automatic();
    if (adapt.floor.kind == Setting::Kind::value) change.floor = Setting::automatic();
    if (change != command::Adapt{}) document_.execute_keeping_message(change);
}

void Editor::restoration_ended() {
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
}

command::Screenshot Editor::picture_command(const std::string& path) const {
    return {
        .path = path,
        .size = glm::clamp(size_, 16, 8192),
        .camera = camera(),
        .show = {
            .wireframe = display.wireframe, .lattice = display.lattice, .levels = display.levels}};
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
    execute(command::Cage{.origin = cage.rest(cage.margin),
                          .cell = cage.cell,
                          .deformable = cage.counts(),
                          .margin = cage.margin});
}

std::optional<Lattice> Editor::editable_cage() const {
    return display.lattice ? session().lattice_settings().cage : std::nullopt;
}

// --- Actions.

void Editor::perform(Action action) {
    if (is_busy()) return;
    switch (action) {
        case Action::undo:
            undo();
            break;
        case Action::redo:
            if (session().redo_count() > 0) execute(command::Redo{});
            break;
        case Action::toggle_symmetry:
            set_symmetry(!session().symmetry());
            break;
        case Action::toggle_pin:
            toggle_pin();
            break;
        case Action::remove_pins:
            pins_.clear();
            break;
        case Action::smaller_radius:
            set_radius(workspace_.radius() / kRadiusStep);
            break;
        case Action::larger_radius:
            set_radius(workspace_.radius() * kRadiusStep);
            break;
        default:
            document_.perform(action);
            perform_on_view(action);
    }
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

void Editor::perform_on_view(Action action) {
    switch (action) {
        case Action::frame_all:
            frame_all();
            break;
        case Action::view_front:
            frame_all(kFrontView);
            break;
        case Action::view_right:
            frame_all(kRightView);
            break;
        case Action::view_top:
            frame_all(kTopView);
            break;
        case Action::toggle_wireframe:
            display.wireframe = !display.wireframe;
            break;
        case Action::toggle_lattice:
            display.lattice = !display.lattice;
            break;
        case Action::toggle_levels:
            display.levels = !display.levels;
            break;
        default:
            break;
    }
}

void Editor::frame_all(const std::optional<Vec3>& direction) {
    const double aspect = kFreeWidth * size_.x / (kFreeHeight * size_.y);
    navigation_.frame(referenced_positions(session().mesh()), aspect, kFreeHeight, direction);
}

}  // namespace pectin

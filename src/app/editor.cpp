#include "app/editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/picture.h"

namespace pectin {
namespace {

constexpr double kRadiusStep = 1.12;
constexpr double kPixelsPerDoubling = 160.0;
// Of the object's box diagonal.
constexpr double kLeastRadius = 1e-3, kMostRadius = 2.0;
// The share of the window that panels leave free on both sides of its middle.
constexpr double kFreeWidth = 0.56, kFreeHeight = 0.78;

bool is_letter(Key key, char letter) { return key == Key{letter}; }

}  // namespace

Editor::Editor(std::optional<Recorder> recorder, std::chrono::milliseconds patience)
    : workspace_(std::move(recorder), patience) {
    frame_all(kFitDirection);
}

// --- Input.

void Editor::handle(const InputEvent& input, const UiClaims& asked) {
    // A dialog takes all, also what comes in before it has been drawn.
    const UiClaims claims = has_dialog() ? UiClaims{.mouse = true, .keyboard = true} : asked;
    if (const auto* press = std::get_if<event::Press>(&input)) {
        on(*press, claims.mouse);
    } else if (const auto* release = std::get_if<event::Release>(&input)) {
        on(*release);
    } else if (const auto* move = std::get_if<event::Move>(&input)) {
        on(*move, claims.mouse);
    } else if (std::holds_alternative<event::Leave>(input)) {
        cursor_is_ours_ = false;
    } else if (const auto* scroll = std::get_if<event::Scroll>(&input)) {
        if (!claims.mouse || sculptor_.is_dragging()) on(*scroll);
    } else if (const auto* down = std::get_if<event::KeyDown>(&input)) {
        on(*down, claims.keyboard);
    } else if (const auto* up = std::get_if<event::KeyUp>(&input)) {
        on(*up);
    } else if (const auto* character = std::get_if<event::Character>(&input)) {
        const auto action = action_for(character->code);
        if (action && !claims.keyboard) perform(*action);
    } else if (const auto* drop = std::get_if<event::Drop>(&input)) {
        on(*drop);
    } else if (const auto* resize = std::get_if<event::Resize>(&input)) {
        if (resize->size.x > 0 && resize->size.y > 0) size_ = resize->size;
    } else if (std::holds_alternative<event::Close>(input)) {
        quit();
    }
}

void Editor::on(const event::Press& press, bool is_claimed) {
    cursor_ = press.at;
    modifiers_ = press.modifiers;
    cursor_is_ours_ = !is_claimed;
    if (radius_drag_) return end_radius_drag(press.button == MouseButton::left);
    if (is_claimed || is_busy() || navigation_.is_active()) return;
    const std::optional<Pick> pick = workspace_.session().pick(view().ray_through(press.at));
    const bool takes_control_points = press.button == MouseButton::left && editable_cage();
    if (takes_control_points &&
        cage_points_.press(session(), view(), press.at, press.modifiers, pick)) {
        workspace_.clear_command_message();
    } else if (const auto mode = navigation_mode(press.button, press.modifiers, pick.has_value())) {
        navigation_.begin(*mode, press.button, press.at);
    } else {
        press_left(press.at, *pick);
    }
}

void Editor::on(const event::Release& release) {
    cursor_ = release.at;
    modifiers_ = release.modifiers;
    if (navigation_.button() == release.button) navigation_.end();
    const bool has_hold = sculptor_.is_dragging() || cage_points_.is_active();
    if (has_hold && release.button == MouseButton::left) release_drag();
}

void Editor::on(const event::Move& move, bool is_claimed) {
    cursor_ = move.at;
    modifiers_ = move.modifiers;
    cursor_is_ours_ = !is_claimed;
    navigation_.move_to(move.at, size_);
    cage_points_.move_to(move.at);
    moved_ = sculptor_.is_dragging() || cage_points_.is_active();
    if (sculptor_.is_dragging()) path_.push_back(move.at);
    if (!radius_drag_) return;
    const double doublings = (move.at.x - radius_drag_->start_x) / kPixelsPerDoubling;
    radius_drag_->radius = std::clamp(radius_drag_->start_radius * std::exp2(doublings),
                                      least_radius(), most_radius());
}

void Editor::on(const event::Scroll& scroll) {
    if (sculptor_.is_dragging()) return rotate_or_scale(scroll.amount);
    if (!is_busy()) navigation_.scroll(scroll.amount, scroll.at, size_);
}

void Editor::on(const event::KeyDown& key, bool is_claimed) {
    modifiers_ = key.modifiers;
    if (key.key == Key::escape) {
        if (!escape_gesture() && !escape_dialog() && !is_claimed) escape_state();
        return;
    }
    if (key.key == Key::enter && !key.is_repeat) enter_ = browser || question || offered_session();
    const auto action = action_for(key.key, key.modifiers);
    if (is_working() && action == Action::quit) return quit();
    if (is_claimed) return;
    if (is_letter(key.key, 'F') && key.modifiers == Modifiers{}) {
        if (!key.is_repeat) begin_radius_drag();
        return;
    }
    const bool repeats = action == Action::undo || action == Action::redo;
    if (action && (!key.is_repeat || repeats)) perform(*action);
}

// Whether there was one to give up.
bool Editor::escape_gesture() {
    if (sculptor_.is_dragging() || cage_points_.is_active()) {
        cancel_drag();
    } else if (radius_drag_) {
        end_radius_drag(false);
    } else {
        return false;
    }
    return true;
}

// One thing at a time.
void Editor::escape_state() {
    if (!workspace_.message().empty()) {
        workspace_.dismiss();
    } else if (sets_pins) {
        sets_pins = false;
    } else {
        cage_points_.select_none();
    }
}

// Whether there was one to leave.
bool Editor::escape_dialog() {
    if (is_working()) {
        cancel_work();
    } else if (!file_to_replace_.empty()) {
        keep_file();
    } else if (offered_session()) {
        answer_recovery(RecoveryAnswer::later);
    } else if (question) {
        answer(Answer::cancel);
    } else if (browser) {
        close_browser();
    } else {
        return false;
    }
    return true;
}

void Editor::on(const event::KeyUp& key) {
    if (is_letter(key.key, 'F') && radius_drag_) end_radius_drag(true);
}

void Editor::on(const event::Drop& drop) {
    if (!drop.paths.empty()) open(drop.paths.front());
}

void Editor::advance() {
    if (sculptor_.is_dragging() || cage_points_.is_active()) {
        if (std::exchange(moved_, false)) drag();
    } else if (restoration_) {
        go_on_restoring();
    } else if (const auto* task = workspace_.file_task()) {
        const Command command = task->command;
        conclude(command, workspace_.poll());
    }
    update_hover();
}

void Editor::update_hover() {
    // A circle that is being set stays where it was.
    if (sculptor_.is_dragging() || cage_points_.is_active() || radius_drag_) return;
    hover_.reset();
    std::optional<IVec3> control_point;
    cage_points_.forget_others(editable_cage());
    if (cursor_is_ours_ && !navigation_.is_active() && !has_dialog()) {
        hover_ = workspace_.session().pick(view().ray_through(cursor_));
        if (editable_cage()) control_point = cage_points_.under(session(), view(), cursor_, hover_);
    }
    cage_points_.set_hovered(control_point);
    if (control_point) hover_.reset();
}

// --- Radius.

double Editor::radius() const { return radius_drag_ ? radius_drag_->radius : workspace_.radius(); }
double Editor::least_radius() const { return kLeastRadius * workspace_.diagonal(); }
double Editor::most_radius() const { return kMostRadius * workspace_.diagonal(); }

void Editor::begin_radius_drag() {
    if (is_busy() || navigation_.is_active()) return;
    radius_drag_ = RadiusDrag{cursor_.x, workspace_.radius(), workspace_.radius()};
}

void Editor::end_radius_drag(bool keeps) {
    const RadiusDrag done = *std::exchange(radius_drag_, std::nullopt);
    if (keeps && done.radius != done.start_radius) set_radius(done.radius);
}

void Editor::set_radius(double radius) {
    execute(command::Brush{.radius = std::clamp(radius, least_radius(), most_radius())});
}

// --- Symmetry and cage.

void Editor::set_symmetry(bool is_on) {
    command::Symmetry symmetry;
    if (is_on) {
        symmetry.plane = mirror_.plane;
        if (mirror_.through_centre) symmetry.through = workspace_.box().centre();
    }
    execute(symmetry);
}

void Editor::choose_mirror(const MirrorChoice& choice) {
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
    if (is_busy()) return;
    switch (action) {
        case Action::undo:
            if (session().undo_count() > 0) {
                execute(command::Undo{});
            } else if (session().history().lost_undo_count() > 0) {
                workspace_.set_message(
                    "Nothing is left to undo: older steps were dropped. Edit, Memory for undo sets "
                    "how much memory they may take.");
            }
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
            perform_on_file(action);
            perform_on_view(action);
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

bool Editor::execute(const Command& command) {
    return !is_busy() && conclude(command, workspace_.execute(command));
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
    navigation_.frame(seen_positions(session().mesh()), aspect, kFreeHeight, direction);
}

}  // namespace pectin

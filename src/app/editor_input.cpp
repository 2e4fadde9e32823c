// How an Editor handles input events.

#include <algorithm>
#include <cmath>
#include <variant>

#include "app/editor.h"

namespace pectin {
namespace {

// The radius doubles when the mouse moves by this many pixels.
constexpr double kPixelsPerDoubling = 160.0;

bool is_letter(Key key, char letter) { return key == Key{letter}; }

}  // namespace

void Editor::handle(const InputEvent& input, const UiClaims& claims) {
    // A dialog takes all input, even before it has been drawn.
    const UiClaims in_force = has_dialog() ? UiClaims{.mouse = true, .keyboard = true} : claims;
    std::visit([&](const auto& event) { on(event, in_force); }, input);
}

// --- Mouse.

void Editor::on(const event::Press& press, const UiClaims& claims) {
    cursor_ = press.at;
    modifiers_ = press.modifiers;
    cursor_in_viewport_ = !claims.mouse;
    if (radius_drag_) return end_radius_drag(press.button == MouseButton::left);
    if (claims.mouse || is_busy() || navigation_.is_active()) return;
    const std::optional<Pick> pick = workspace_.session().pick(view().ray_through(press.at));
    const bool drags_control_points = press.button == MouseButton::left && editable_cage();
    if (drags_control_points &&
        cage_points_.press(session(), view(), press.at, press.modifiers, pick)) {
        workspace_.clear_command_message();
    } else if (const auto mode = navigation_mode(press.button, press.modifiers, pick.has_value())) {
        navigation_.begin(*mode, press.button, press.at);
    } else {
        press_on_surface(press.at, *pick);
    }
}

void Editor::on(const event::Release& release, const UiClaims&) {
    cursor_ = release.at;
    modifiers_ = release.modifiers;
    if (navigation_.button() == release.button) navigation_.end();
    if (has_drag() && !is_working() && release.button == MouseButton::left) release_drag();
}

void Editor::on(const event::MouseMove& move, const UiClaims& claims) {
    cursor_ = move.at;
    modifiers_ = move.modifiers;
    cursor_in_viewport_ = !claims.mouse;
    navigation_.move_to(move.at, size_);
    cage_points_.move_to(move.at);
    drag_is_stale_ = has_drag();
    if (sculptor_.is_dragging()) cursor_path_.push_back(move.at);
    if (!radius_drag_) return;
    const double doublings = (move.at.x - radius_drag_->start_x) / kPixelsPerDoubling;
    radius_drag_->radius =
        std::clamp(radius_drag_->start_radius * std::exp2(doublings), min_radius(), max_radius());
}

void Editor::on(const event::Leave&, const UiClaims&) { cursor_in_viewport_ = false; }

void Editor::on(const event::Scroll& scroll, const UiClaims& claims) {
    if (sculptor_.is_dragging() && !is_working()) return rotate_or_scale(scroll.amount);
    if (!claims.mouse && !is_busy()) navigation_.scroll(scroll.amount, scroll.at, size_);
}

// --- Keyboard.

void Editor::on(const event::KeyDown& key, const UiClaims& claims) {
    modifiers_ = key.modifiers;
    if (key.key == Key::escape) return escape(claims.keyboard);
    if (key.key == Key::enter && !key.is_repeat) {
        enter_pressed_ = browser || question || offered_session();
    }
    const auto action = action_for(key.key, key.modifiers);
    if (is_working() && action == Action::quit) return quit();
    if (claims.keyboard) return;
    if (is_letter(key.key, 'F') && key.modifiers == Modifiers{}) {
        if (!key.is_repeat) begin_radius_drag();
        return;
    }
    if (action && (!key.is_repeat || info_of(*action).repeats)) perform(*action);
}

void Editor::on(const event::KeyUp& key, const UiClaims&) {
    if (is_letter(key.key, 'F') && radius_drag_) end_radius_drag(true);
}

void Editor::on(const event::Character& character, const UiClaims& claims) {
    const auto action = action_for(character.code);
    if (action && !claims.keyboard) perform(*action);
}

// Escape ends one thing at a time.
void Editor::escape(bool is_claimed) {
    if (!escape_gesture() && !escape_dialog() && !is_claimed) escape_state();
}

// Returns whether there was a gesture to cancel.
bool Editor::escape_gesture() {
    if (is_working()) return false;
    if (has_drag()) {
        cancel_drag();
    } else if (radius_drag_) {
        end_radius_drag(false);
    } else {
        return false;
    }
    return true;
}

// Returns whether there was a dialog to close.
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

void Editor::escape_state() {
    if (!workspace_.message().empty()) {
        workspace_.dismiss();
    } else if (sets_pins) {
        sets_pins = false;
    } else {
        cage_points_.clear_selection();
    }
}

// --- Window.

void Editor::on(const event::Drop& drop, const UiClaims&) {
    if (!drop.paths.empty()) open(drop.paths.front());
}

void Editor::on(const event::Resize& resize, const UiClaims&) {
    if (resize.size.x > 0 && resize.size.y > 0) size_ = resize.size;
}

void Editor::on(const event::Focus&, const UiClaims&) {}

void Editor::on(const event::Close&, const UiClaims&) { quit(); }

}  // namespace pectin

// How an Editor passes input events to tools and navigation, and what it does in each frame.

#include <algorithm>
#include <new>
#include <string>
#include <utility>
#include <variant>

#include "app/editor.h"
#include "app/execute.h"
#include "app/words.h"

namespace pectin {
namespace {

constexpr Key kNormalKey{'N'};

}  // namespace

void Editor::handle(const InputEvent& input, const UiClaims& claims) {
    // A dialog takes all input, even before it has been drawn.
    const UiClaims in_force = has_dialog() ? UiClaims{.mouse = true, .keyboard = true} : claims;
    std::visit([&](const auto& event) { on(event, in_force); }, input);
}

// --- Tools.

// The tool whose gesture goes on, or whose drag is being ended in the background; null if there is
// none.
Tool* Editor::active_tool() const {
    const auto active = std::ranges::find_if(tools_, [](const auto& t) { return t->is_active(); });
    return active == tools_.end() ? nullptr : active->get();
}

bool Editor::is_dragging() const {
    const Tool* const tool = active_tool();
    return (tool && tool->is_dragging()) || example_.is_moving();
}

// Runs something that a tool does. If it throws, the tool's gesture is cancelled. Returns whether
// it did not throw.
template <typename Part>
bool Editor::run(Part part) {
    try {
        part();
        if (is_dragging()) {
            shows_hint_ = false;
            hover_.reset();
        }
        return true;
    } catch (const std::bad_alloc&) {
        handle_out_of_memory("drag");
    } catch (const std::exception& error) {
        cancel_gesture();
        workspace_.set_message("The drag was cancelled. " + sentences(error.what()));
    }
    return false;
}

// Offers an event to the tools, one after the other. Returns whether one has taken it.
template <typename Offer>
bool Editor::offer_to_tools(Offer offer) {
    if (example_.is_moving()) return false;  // the view can still be moved
    bool is_taken = false;
    const bool is_done = run([&] {
        is_taken = std::ranges::any_of(tools_, [&](const auto& tool) { return offer(*tool); });
    });
    return is_taken || !is_done;
}

void Editor::cancel_gesture() noexcept {
    if (Tool* const tool = active_tool()) tool->cancel(*this);
    example_.cancel();
}

void Editor::handle_out_of_memory(const char* what) noexcept {
    if (workspace_.edit_task()) return;  // the session, also its history, is in use
    cancel_gesture();
    try {
        workspace_.set_message(sentences(not_enough_memory(what, session().history())));
    } catch (const std::bad_alloc&) {
        // There is not even enough memory for the message.
    }
}

// --- Frames.

void Editor::advance() {
    if (is_working()) {
        advance_work();
    } else if (Tool* const tool = active_tool()) {
        run([&] { tool->advance(*this); });
    } else if (!has_dialog()) {
        detail_preview.advance(session());
        view_control_.follow_free_area();
        run([&] { example_.advance(std::chrono::steady_clock::now()); });
    }
    if (document_.has_dialog()) help_page_.reset();  // only one may be open
    update_hover();
}

bool Editor::has_unfinished_frame() const {
    if (is_working()) return false;
    return session().has_unfinished_frame() || detail_preview.has_more() ||
           (!has_dialog() && example_.needs_frame(std::chrono::steady_clock::now()));
}

void Editor::advance_work() {
    const EditTask* const edit = workspace_.edit_task();
    const bool is_end_of_drag = edit && !edit->command();
    if (!is_end_of_drag) return document_.advance();
    const Workspace::Outcome outcome = workspace_.poll();
    if (outcome == Workspace::Outcome::in_progress) return;
    if (Tool* const tool = active_tool()) {
        run([&] { tool->finish(*this, outcome); });
    } else {
        example_.finish();
    }
    document_.continue_quitting();
}

std::optional<Pick> Editor::pick_in_middle() {
    return workspace_.session().pick(view().ray_through(0.5 * Vec2(size())));
}

void Editor::update_hover() {
    if (active_tool()) return;
    hover_.reset();
    if (example_.is_moving()) return;
    bool is_free = pointer_.is_in_viewport && !has_dialog() &&
                   !view_control_.has_priority(pointer_.at, pointer_.modifiers, holds_space_);
    if (is_free) hover_ = pick_at_cursor();
    // While a panel sets the radius, the middle of the window shows it.
    if (radius_preview && !is_working() && !has_dialog()) hover_ = pick_in_middle();
    for (const auto& tool : tools_) {
        if (!tool->hover(*this, is_free)) continue;
        is_free = false;
        hover_.reset();
    }
}

// --- Mouse.

void Editor::on(const event::Press& press, const UiClaims& claims) {
    set_pointer(press.at, press.modifiers, !claims.mouse);
    if (is_working()) return;
    if (Tool* const tool = active_tool()) {
        run([&] { tool->press(*this, press.button); });
    } else if (!claims.mouse && !view_control_.is_active() &&
               !view_control_.press_before_tools(press, holds_space_) &&
               !offer_to_tools([&](Tool& t) { return t.press(*this, press.button); })) {
        view_control_.press(press);
    }
}

void Editor::on(const event::Release& release, const UiClaims&) {
    set_pointer(release.at, release.modifiers, pointer_.is_in_viewport);
    view_control_.release(release.button);
    Tool* const tool = active_tool();
    if (tool && !is_working()) run([&] { tool->release(*this, release.button); });
}

void Editor::on(const event::MouseMove& move, const UiClaims& claims) {
    set_pointer(move.at, move.modifiers, !claims.mouse);
    view_control_.move(move.at, move.modifiers);
    Tool* const tool = active_tool();
    if (tool && !is_working()) run([&] { tool->move(*this); });
}

void Editor::on(const event::Leave&, const UiClaims&) { pointer_.is_in_viewport = false; }

void Editor::on(const event::Scroll& scroll, const UiClaims& claims) {
    if (is_working()) return;
    if (Tool* const tool = active_tool()) {
        run([&] { tool->scroll(*this, scroll.amount); });
    } else if (!claims.mouse &&
               !offer_to_tools([&](Tool& t) { return t.scroll(*this, scroll.amount); })) {
        view_control_.scroll(scroll, pointer_.modifiers);
    }
}

// --- Keyboard.

void Editor::set_pointer(const Vec2& at, const Modifiers& modifiers, bool is_in_viewport) {
    const bool holds_alt = modifiers.alt && alt_drags_along_normal(preferences.mouse);
    pointer_ = {at, modifiers, is_in_viewport, holds_normal_key_ || holds_alt};
}

// Takes note of the keys that mean something while they are held: Space moves the view, and N makes
// drags go along the normal.
void Editor::hold(Key key, bool is_held) {
    if (key == Key::space) holds_space_ = is_held;
    if (key != kNormalKey || holds_normal_key_ == is_held) return;
    holds_normal_key_ = is_held;
    set_pointer(pointer_.at, pointer_.modifiers, pointer_.is_in_viewport);
    Tool* const tool = active_tool();
    if (tool && !is_working()) run([&] { tool->move(*this); });
}

void Editor::on(const event::KeyDown& key, const UiClaims& claims) {
    set_pointer(pointer_.at, key.modifiers, pointer_.is_in_viewport);
    if (!claims.keyboard) hold(key.key, true);
    if (key.key == Key::escape) return escape(claims.keyboard);
    if (key.key == Key::enter && !key.is_repeat) document_.press_enter();
    const auto action = action_for(key.key, key.modifiers);
    if (is_working() && action == Action::quit) return document_.quit();
    const bool is_help = action && info_of(*action).menu == Menu::help;
    if (help_page_ && is_help && !key.is_repeat) return perform(*action);
    if (claims.keyboard || is_working()) return;
    if (Tool* const tool = active_tool()) {
        run([&] { tool->key(*this, key); });
    } else if (view_control_.is_active() ||
               !offer_to_tools([&](Tool& t) { return t.key(*this, key); })) {
        if (action && (!key.is_repeat || info_of(*action).repeats)) perform(*action);
    }
}

void Editor::on(const event::KeyUp& key, const UiClaims&) {
    hold(key.key, false);
    Tool* const tool = active_tool();
    if (tool && !is_working()) run([&] { tool->key_up(*this, key.key); });
}

void Editor::on(const event::Character& character, const UiClaims& claims) {
    Tool* const tool = active_tool();
    if (tool && !is_working() && !claims.keyboard) {
        run([&] { tool->character(*this, character.code); });
        return;
    }
    const auto action = action_for(character.code);
    if (action && !claims.keyboard) perform(*action);
}

// Escape ends one thing at a time.
void Editor::escape(bool is_claimed) {
    if (escape_gesture() || document_.escape()) return;
    if (help_page_) return close_help();
    if (!is_claimed) escape_state();
}

// Returns whether there was a gesture to cancel.
bool Editor::escape_gesture() {
    if (is_working() || !active_tool()) return false;
    cancel_gesture();
    return true;
}

// The last tool is asked first. So Esc ends the setting of pins before it clears a selection of
// control points.
void Editor::escape_state() {
    if (example_.is_open()) return example_.stop();
    if (!workspace_.message().empty()) return workspace_.dismiss();
    for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool) {
        if ((*tool)->escape(*this)) return;
    }
}

// --- Window.

void Editor::on(const event::Drop& drop, const UiClaims&) {
    if (drop.paths.empty()) return;
    example_.interrupt();
    document_.open(drop.paths.front());
}

void Editor::on(const event::Resize& resize, const UiClaims&) {
    if (resize.size.x > 0 && resize.size.y > 0) view_control_.resize(resize.size);
}

// Keys and buttons may be released unseen from now on.
void Editor::on(const event::Focus& focus, const UiClaims&) {
    if (focus.gained) return;
    pointer_.modifiers = {};
    hold(Key::space, false);
    hold(kNormalKey, false);
    view_control_.cancel();
    Tool* const tool = active_tool();
    if (tool && !is_working()) run([&] { tool->lose_focus(*this); });
}

void Editor::on(const event::Close&, const UiClaims&) {
    example_.interrupt();
    document_.quit();
}

}  // namespace pectin

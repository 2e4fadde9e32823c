// How an Editor offers and restores lost sessions.

#include <utility>

#include "app/editor.h"

namespace pectin {

void Editor::answer_recovery(RecoveryAnswer answer) {
    enter_pressed_ = false;
    if (answer == RecoveryAnswer::discard) {
        remove_lost_session(lost_sessions_.front());
        lost_sessions_.erase(lost_sessions_.begin());
        return;  // the next session is offered
    }
    std::vector<LostSession> sessions = std::exchange(lost_sessions_, {});
    if (answer == RecoveryAnswer::restore) restoration_.emplace(std::move(sessions.front()));
}

void Editor::continue_restoring() {
    const Restoration::State state = restoration_->advance(workspace_);
    if (state == Restoration::State::in_progress) return;
    const Restoration ended = std::move(*restoration_);
    restoration_.reset();
    const std::string message = end_restoring(ended, state);
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
    workspace_.set_message(message);
    if (std::exchange(quits_next_, false)) quit();
}

// Leaves an object in the window, and decides what becomes of the session's file. Returns the
// message for the user.
std::string Editor::end_restoring(const Restoration& ended, Restoration::State state) {
    if (state == Restoration::State::done) {
        remove_lost_session(ended.session());
        return "The session was restored. Save the object to keep it.";
    }
    const bool has_failed = state == Restoration::State::failed;
    const std::string error = workspace_.command_message();
    if (has_failed && session().mesh().face_slots() > 0) {
        // The next save must not replace the model's file by a part of the session.
        workspace_.clear_path();
        return "Restored up to command " + std::to_string(ended.commands_done()) + " of " +
               std::to_string(ended.command_count()) + ": " + error +
               ". All commands are kept as a script in " + set_aside(ended.session().path) + ".";
    }
    execute(kFirstObject);
    return "The session was not restored" + (has_failed ? ": " + error : "") +
           ". It is offered again at the next start.";
}

}  // namespace pectin

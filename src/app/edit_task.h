// Edits of the object in the background.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "app/background_task.h"
#include "command/command.h"
#include "session/session.h"

namespace pectin {

struct EditResult {
    Done done{};
    // Of a drag: the command that it amounts to, or nothing if it has moved nothing.
    std::optional<Command> drag{};
};

// An edit of a session's object, on a thread of its own. Until it has ended, nothing of the session
// may be used but its settings, which edits only read. Throws nothing of its own; take() throws
// Stopped if the edit was cancelled, and the object is then as before, byte for byte.
class EditTask {
  public:
    // Executes a command: an edit (see is_edit()).
    EditTask(Session& session, const Command& command);
    // Ends the drag of points or control points that is active.
    explicit EditTask(Session& session);

    const std::optional<Command>& command() const { return command_; }  // none: the end of a drag
    bool has_ended(std::chrono::milliseconds longest_wait) const {
        return work_->has_ended(longest_wait);
    }
    EditResult take() { return work_->take(); }
    void cancel() { work_->cancel(); }
    bool is_cancelled() const { return work_->is_cancelled(); }

    std::chrono::steady_clock::duration duration() const {
        return std::chrono::steady_clock::now() - begin_;
    }
    // Of the object as far as the edit has got.
    std::uint64_t faces() const { return faces_; }

  private:
    StopToken stop_token(const Progress& progress);

    Session& session_;
    std::optional<Command> command_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::atomic<std::uint64_t> faces_;
    std::optional<BackgroundTask<EditResult>> work_;  // last, so that it ends before the others
};

// Whether the command changes the object of the session and neither replaces it nor needs files.
bool is_edit(const Command& command);

}  // namespace pectin

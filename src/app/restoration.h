// Executes the commands of a lost session again, a few at a time, so that the window stays
// responsive.
#pragma once

#include <cstddef>
#include <vector>

#include "app/lost_sessions.h"
#include "app/workspace.h"

namespace pectin {

class Restoration {
  public:
    explicit Restoration(LostSession session);

    enum class State { in_progress, done, failed, cancelled };
    // Continues for about kTimePerFrame, but at least with one command or a part of a file. If it
    // fails, the workspace's message says why.
    // Precondition: the state is in_progress.
    State advance(Workspace& workspace);
    // The next advance() ends with State::cancelled, once the present command has stopped.
    void cancel(Workspace& workspace);
    bool is_cancelled() const { return is_cancelled_; }

    const LostSession& session() const { return session_; }
    std::size_t commands_done() const { return next_; }
    std::size_t command_count() const { return steps_.size(); }
    // The part of the commands that is done, from 0 to 1.
    double fraction() const;

  private:
    State advance_once(Workspace& workspace);
    Workspace::Outcome execute_step(std::size_t command_index, Workspace& workspace) const;

    LostSession session_;
    std::vector<std::size_t> steps_;  // indices of the session's commands that are executed again
    std::size_t next_ = 0;            // index into steps_
    bool has_begun_ = false, is_cancelled_ = false;
};

}  // namespace pectin

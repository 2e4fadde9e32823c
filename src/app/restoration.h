// Does again what a lost session did, a few commands at a time, so that the window goes on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/recovery.h"
#include "app/workspace.h"

namespace pectin {

class Restoration {
  public:
    explicit Restoration(LostSession session);

    enum class State { under_way, done, failed, cancelled };
    // Goes on for a moment; at least one command, or a part of a file. Where it has failed, the
    // workspace tells why. Precondition: it is under way.
    State advance(Workspace& workspace);
    // It is `cancelled` once the command that it is at has ended.
    void cancel(Workspace& workspace);
    bool is_cancelled() const { return is_cancelled_; }

    const LostSession& session() const { return session_; }
    std::size_t done() const { return next_; }
    std::size_t count() const { return steps_.size(); }
    double fraction() const;

  private:
    State advance_once(Workspace& workspace);
    Workspace::Outcome redo(std::size_t step, Workspace& workspace) const;

    LostSession session_;
    std::vector<std::size_t> steps_;  // the commands of the session that are done again
    std::size_t next_ = 0;            // of the steps
    bool has_begun_ = false, is_cancelled_ = false;
};

}  // namespace pectin

// A drag of an example, shown as a motion: from where it begins, over its waypoints, to where it
// ends.
#pragma once

#include <vector>

#include "command/command.h"
#include "command/result.h"
#include "render/overlay.h"
#include "session/session.h"

namespace pectin {

// Only drags and moves of control points are motions; other commands happen at once.
bool is_motion(const Command& command);

class ExampleMotion {
  public:
    // Begins the drag in the session. Precondition: is_motion(command).
    Done begin(Session& session, const Command& command);
    // Moves what is dragged to where it is at this part of the motion, from 0 to 1.
    Done move_to(Session& session, double part);
    // The session's drag was ended or cancelled.
    void end() { command_.reset(); }
    bool is_active() const { return command_.has_value(); }
    // Precondition: is_active().
    const Command& command() const { return *command_; }

    // Shows what is dragged, in a session whose drag may be used.
    void overlay(const Session& session, Overlay& overlay) const;

  private:
    Done begin_drag(Session& session, const command::Drag& drag);
    Done begin_control(Session& session, const command::Control& control);
    std::vector<Move> moves_at(const command::Drag& drag, double part) const;

    std::optional<Command> command_;
    double part_ = 0.0;
    std::vector<Vec3> rest_;  // of the control points
};

}  // namespace pectin

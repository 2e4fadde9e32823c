#include "app/edit_task.h"

#include <cassert>
#include <utility>

#include "app/command_kind.h"
#include "geometry/parallel.h"

namespace pectin {
namespace {

// The command that takes back what this one does, for commands that may be done before
// Session::execute() asks whether to stop: undo never asks, and redo only where it splits.
std::optional<Command> inverse(const Command& command) {
    if (const auto* undo = std::get_if<command::Undo>(&command)) {
        return command::Redo{.count = undo->count};
    }
    if (const auto* redo = std::get_if<command::Redo>(&command)) {
        return command::Undo{.count = redo->count};
    }
    return std::nullopt;
}

}  // namespace

bool is_edit(const Command& command) {
    return is_any_of<command::Drag, command::Control, command::Undo, command::Redo,
                     command::Readapt, command::Bake>(command);
}

EditTask::EditTask(Session& session, const Command& command)
    : session_(session), command_(command), faces_(session.mesh().face_count()) {
    work_.emplace([this](const Progress& progress) {
        prepare_parallel_loops();
        const StopToken stop = stop_token(progress);
        EditResult result{.done = session_.execute(*command_, stop)};
        const std::optional<Command> back = inverse(*command_);
        if (result.done && back && stop.stop_requested()) {
            // It was done a moment ago, so it can be taken back.
            [[maybe_unused]] const Done taken_back = session_.execute(*back);
            assert(taken_back);
            throw Stopped();
        }
        session_.prepare_for_drags();
        return result;
    });
}

EditTask::EditTask(Session& session) : session_(session), faces_(session.mesh().face_count()) {
    work_.emplace([this](const Progress& progress) {
        prepare_parallel_loops();
        const StopToken stop = stop_token(progress);
        EditResult result;
        if (session_.is_dragging_control_points()) {
            if (auto done = session_.end_control(stop)) result.drag = std::move(*done);
        } else if (auto done = session_.end_drag(stop)) {
            result.drag = std::move(*done);
        }
        return result;
    });
}

// The token is asked on the thread that works, so the mesh may be read here.
StopToken EditTask::stop_token(const Progress& progress) {
    return StopToken([this, progress] {
        faces_ = session_.mesh().face_count();
        return progress.is_stop_requested();
    });
}

}  // namespace pectin

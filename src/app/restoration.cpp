#include "app/restoration.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "app/command_kind.h"
#include "app/recovery_file.h"

namespace pectin {
namespace {

// The longest time for which a window may do nothing else.
constexpr std::chrono::milliseconds kTimePerFrame{50};

bool is_setting(const Command& command) {
    return is_any_of<command::Adapt, command::Brush, command::Cage, command::Symmetry,
                     command::History>(command);
}

bool is_fitted_cage(const Command& command) {
    const auto* cage = std::get_if<command::Cage>(&command);
    return cage && cage->fit.has_value();
}

// Returns the indices of the commands on which the last object depends. Of the commands before it
// only the settings still matter, so models that were opened earlier need not exist any more. But
// if a cage was fitted to an earlier object, all commands are needed.
std::vector<std::size_t> needed_commands(const std::vector<Command>& commands) {
    const auto last = std::find_if(commands.rbegin(), commands.rend(), makes_object);
    const auto object = static_cast<std::size_t>(commands.rend() - last);
    const bool needs_all = std::any_of(
        commands.begin(), commands.begin() + static_cast<std::ptrdiff_t>(object), is_fitted_cage);
    std::vector<std::size_t> needed;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (needs_all || i + 1 >= object || is_setting(commands[i])) needed.push_back(i);
    }
    return needed;
}

}  // namespace

Restoration::Restoration(LostSession session)
    : session_(std::move(session)), steps_(needed_commands(session_.commands)) {}

Restoration::State Restoration::advance(Workspace& workspace) {
    if (!std::exchange(has_begun_, true)) workspace.reset_session();
    const auto end = std::chrono::steady_clock::now() + kTimePerFrame;
    State state = State::in_progress;
    do {
        state = advance_once(workspace);
    } while (state == State::in_progress && !workspace.is_working() &&
             std::chrono::steady_clock::now() < end);
    return state;
}

Restoration::State Restoration::advance_once(Workspace& workspace) {
    if (is_cancelled_ && !workspace.is_working()) return State::cancelled;
    if (next_ == steps_.size()) return State::done;
    const Workspace::Outcome outcome =
        workspace.is_working() ? workspace.poll() : execute_step(steps_[next_], workspace);
    if (outcome == Workspace::Outcome::failed) {
        return is_cancelled_ ? State::cancelled : State::failed;
    }
    if (outcome == Workspace::Outcome::done) ++next_;
    return next_ == steps_.size() ? State::done : State::in_progress;
}

Workspace::Outcome Restoration::execute_step(std::size_t command_index,
                                             Workspace& workspace) const {
    const Command& command = session_.commands[command_index];
    const std::string& fingerprint = session_.fingerprints[command_index];
    if (const auto* save = std::get_if<command::Save>(&command)) {
        workspace.skip_save(*save);
        return Workspace::Outcome::done;
    }
    if (!is_restored(command)) return Workspace::Outcome::done;
    const auto* open = std::get_if<command::Open>(&command);
    if (open && !fingerprint.empty()) return workspace.reopen(*open, session_, fingerprint);
    return workspace.execute(command);
}

void Restoration::cancel(Workspace& workspace) {
    is_cancelled_ = true;
    if (workspace.is_working()) workspace.cancel_work();
}

double Restoration::fraction() const {
    return steps_.empty() ? 1.0 : static_cast<double>(next_) / static_cast<double>(steps_.size());
}

}  // namespace pectin

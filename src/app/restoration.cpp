#include "app/restoration.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

namespace pectin {
namespace {

// How long a window may stand still.
constexpr std::chrono::milliseconds kMoment{50};

bool makes_object(const Command& command) {
    return std::holds_alternative<command::Open>(command) ||
           std::holds_alternative<command::Shape>(command);
}

bool is_setting(const Command& command) {
    return std::holds_alternative<command::Adapt>(command) ||
           std::holds_alternative<command::Brush>(command) ||
           std::holds_alternative<command::Cage>(command) ||
           std::holds_alternative<command::Symmetry>(command) ||
           std::holds_alternative<command::History>(command);
}

bool is_fitted_cage(const Command& command) {
    const auto* cage = std::get_if<command::Cage>(&command);
    return cage && std::holds_alternative<command::Cage::Fit>(cage->lattice);
}

// The commands that the last object depends on. Of what was done before it only settings remain,
// so models that were opened earlier need not be there any more; but a cage may have been fitted to
// an earlier object, and then all of them are needed.
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
    if (!std::exchange(has_begun_, true)) workspace.begin_anew();
    const auto end = std::chrono::steady_clock::now() + kMoment;
    State state = State::under_way;
    do {
        state = advance_once(workspace);
    } while (state == State::under_way && !workspace.file_task() &&
             std::chrono::steady_clock::now() < end);
    return state;
}

Restoration::State Restoration::advance_once(Workspace& workspace) {
    if (is_cancelled_ && !workspace.file_task()) return State::cancelled;
    if (next_ == steps_.size()) return State::done;
    const Workspace::Outcome outcome =
        workspace.file_task() ? workspace.poll() : redo(steps_[next_], workspace);
    if (outcome == Workspace::Outcome::failed) {
        return is_cancelled_ ? State::cancelled : State::failed;
    }
    if (outcome == Workspace::Outcome::done) ++next_;
    return next_ == steps_.size() ? State::done : State::under_way;
}

Workspace::Outcome Restoration::redo(std::size_t step, Workspace& workspace) const {
    const Command& command = session_.commands[step];
    const std::string& fingerprint = session_.fingerprints[step];
    if (const auto* save = std::get_if<command::Save>(&command)) {
        workspace.pass_over(*save);
        return Workspace::Outcome::done;
    }
    if (!is_restored(command)) return Workspace::Outcome::done;
    const auto* open = std::get_if<command::Open>(&command);
    if (open && !fingerprint.empty()) return workspace.reopen(*open, session_, fingerprint);
    return workspace.execute(command);
}

void Restoration::cancel(Workspace& workspace) {
    is_cancelled_ = true;
    if (workspace.file_task()) workspace.cancel_file_task();
}

double Restoration::fraction() const {
    return steps_.empty() ? 1.0 : static_cast<double>(next_) / static_cast<double>(steps_.size());
}

}  // namespace pectin

// Steps of the history: how an edit becomes one, undo, redo, and the limit of memory.
#include <cmath>
#include <utility>

#include "geometry/decimal.h"
#include "session/session_state.h"

namespace pectin {
namespace {

constexpr double kMegabyte = 1e6;  // bytes, as the window shows memory
constexpr double kMostBytes = 0x1p63;

std::string counted_steps(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " step" : " steps");
}

std::string too_few(const char* what, std::size_t there, std::size_t asked) {
    return (there == 1 ? "there is only " : "there are only ") + counted_steps(there) + " to " +
           what + ", not " + std::to_string(asked);
}

std::string remark_on_dropped_steps(std::size_t count, std::size_t limit) {
    return "the " + (count == 1 ? "oldest step" : std::to_string(count) + " oldest steps") +
           " can no longer be undone, since undo may take at most " +
           decimal(static_cast<double>(limit) / kMegabyte) +
           " MB of memory; a larger limit keeps more steps";
}

}  // namespace

void Session::State::exchange(TriMesh& other) {
    std::swap(*mesh, other);
    update_everything();
}

// Updates the outcome when undo or redo ends, even if it stops before the last step because memory
// has run out.
struct Session::State::UpdateOutcomeAtExit {
    State& state;
    ~UpdateOutcomeAtExit() { state.outcome = state.history.outcome(); }
};

void Session::State::add_step(Command command, MeshChange& change) {
    update_faces(change.faces);
    if (change.is_empty()) return history.set_outcome(outcome);
    History::Step step{std::move(command), std::move(change), outcome};
    try {
        history.add(std::move(step));
    } catch (...) {
        change = std::move(step.change);
        throw;
    }
}

void Session::State::report_dropped_steps() noexcept {
    const std::size_t count = history.take_dropped_count();
    if (count == 0 || !history.limit()) return;
    try {
        if (!remark.empty()) remark += "; ";
        remark += remark_on_dropped_steps(count, *history.limit());
    } catch (const std::bad_alloc&) {
        // The step succeeds without the remark.
    }
}

void Session::State::undo_steps(std::size_t count) {
    history.undo(count, [this](History::Step& step) {
        if (step.exchanged) {
            exchange(*step.exchanged);
        } else {
            undo(step.change, *mesh);
            update_faces(step.change.faces);
        }
    });
}

Done Session::State::run(const command::Undo& undo_command) {
    const auto count = static_cast<std::size_t>(undo_command.count);
    if (count > history.undo_count()) {
        std::string text = too_few("undo", history.undo_count(), count);
        if (const std::size_t lost = history.lost_undo_count(); lost > 0) {
            text += "; " + std::to_string(lost) +
                    (lost == 1 ? " older step was" : " older steps were") +
                    " dropped to keep to the memory that history allows";
        }
        return Refusal{std::move(text), "count"};
    }
    const UpdateOutcomeAtExit update_outcome_at_exit{*this};
    undo_steps(count);
    return {};
}

Done Session::State::run(const command::Redo& redo_command) {
    const auto count = static_cast<std::size_t>(redo_command.count);
    if (count > history.redo_count()) {
        return Refusal{too_few("redo", history.redo_count(), count), "count"};
    }
    const UpdateOutcomeAtExit update_outcome_at_exit{*this};
    const std::size_t done_before = history.undo_count();
    try {
        history.redo(count, [this](History::Step& step) {
            if (step.exchanged) {
                exchange(*step.exchanged);
            } else {
                redo(step.change, *mesh, stop);
                update_faces(step.change.faces);
            }
        });
    } catch (const Stopped&) {
        undo_steps(history.undo_count() - done_before);
        throw;
    }
    return {};
}

Done Session::State::run(const command::History& limit) {
    if (!limit.megabytes) return {};
    const Setting& megabytes = *limit.megabytes;
    if (megabytes.is_off()) {
        history.set_limit(std::nullopt);
        return {};
    }
    const double bytes = kMegabyte * megabytes.value;
    history.set_limit(bytes < kMostBytes ? std::optional(static_cast<std::size_t>(bytes))
                                         : std::nullopt);
    return {};
}

}  // namespace pectin

#include "session/history.h"

#include <utility>

#include "mesh/array_bytes.h"

namespace pectin {
namespace {

// The memory that a command owns, for the commands that can be steps.
std::size_t owned_bytes(const Command& command) {
    if (const auto* drag = std::get_if<command::Drag>(&command)) {
        return capacity_bytes(drag->moves) + capacity_bytes(drag->pins) + capacity_bytes(drag->via);
    }
    const auto* control = std::get_if<command::Control>(&command);
    return control ? capacity_bytes(control->points) : 0;
}

}  // namespace

std::size_t History::Step::memory_bytes() const {
    return sizeof(Step) + owned_bytes(command) + change.memory_bytes() +
           (exchanged ? sizeof(TriMesh) + exchanged->memory_bytes() : 0);
}

void History::measure(Entry& entry) {
    bytes_ -= entry.bytes;
    entry.bytes = entry.step.memory_bytes();
    bytes_ += entry.bytes;
}

void History::add(Step&& step) {
    steps_.emplace_back();
    std::swap(steps_[done_], steps_.back());  // the steps that could be redone are dropped below
    steps_[done_].step = std::move(step);
    steps_[done_].state_id = ++last_state_;
    ++done_;
    while (redo_count() > 0) drop_last();
    measure(steps_.back());
    keep_limit();
}

void History::clear() noexcept {
    steps_.clear();  // assigning an empty deque would allocate
    done_ = 0;
    lost_undos_ = 0;
    dropped_ = 0;
    first_outcome_ = {};
    first_state_ = ++last_state_;
    bytes_ = 0;
}

void History::forget_limits() noexcept {
    for (Entry& entry : steps_) entry.step.outcome.forget_limits();
    first_outcome_.forget_limits();
}

void History::set_limit(std::optional<std::size_t> limit) {
    limit_ = limit;
    keep_limit();
}

void History::keep_limit() {
    while (limit_ && bytes_ > *limit_ && steps_.size() > 1 && done_ > 0) drop_oldest();
}

void History::drop_oldest() {
    Entry& oldest = steps_.front();
    bytes_ -= oldest.bytes;
    first_outcome_ = oldest.step.outcome;
    first_state_ = oldest.state_id;
    steps_.pop_front();
    --done_;
    ++lost_undos_;
    ++dropped_;
}

void History::drop_last() {
    bytes_ -= steps_.back().bytes;
    steps_.pop_back();
}

}  // namespace pectin

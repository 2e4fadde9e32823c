#include "session/history.h"

#include <utility>

namespace pectin {

void History::add(Step step) {
    steps_.resize(done_);
    steps_.push_back(std::move(step));
    ++done_;
}

void History::clear() {
    steps_.clear();
    done_ = 0;
}

History::Step& History::step_back() { return steps_[--done_]; }

History::Step& History::step_forward() { return steps_[done_++]; }

void History::forget_outcomes() {
    for (Step& step : steps_) step.outcome = {};
}

std::size_t History::memory_bytes() const {
    std::size_t bytes = steps_.capacity() * sizeof(Step);
    for (const Step& step : steps_) {
        bytes += step.change.memory_bytes();
        if (step.exchanged) bytes += step.exchanged->memory_bytes();
    }
    return bytes;
}

}  // namespace pectin

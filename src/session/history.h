// The history for undo and redo: the commands that changed the object and their changes, within a
// limit of memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "adapt/adapt.h"
#include "command/command.h"
#include "command/statistics.h"
#include "mesh/mesh_change.h"

namespace pectin {

// Where adaptive meshing has stopped short, for the mesh after a step.
struct AdaptOutcome {
    bool floor_hit = false;
    bool budget_hit = false;
    bool drag_budget_hit = false;  // in this step or an earlier one, with the present settings
    Assessment assessment{};       // of the edges that the step could refine
    Statistics::Error error{.last = std::nullopt, .total = 0.0};

    bool has_ended_at_budget() const { return budget_hit || drag_budget_hit; }
    // Which limits were hit means nothing after a change of settings.
    void forget_limits() { floor_hit = budget_hit = drag_budget_hit = false; }
};

class History {
  public:
    struct Step {
        Command command;
        MeshChange change;
        AdaptOutcome outcome;
        // For a bake, which renumbers everything: the mesh before it, or the mesh after it once it
        // is undone. Otherwise null.
        std::unique_ptr<TriMesh> exchanged{};

        std::size_t memory_bytes() const;
    };

    // Enough for a thousand drags of ten thousand vertices each, or for fifteen drags of a whole
    // model of 1.3 million faces. A machine with 4 GB has as much left beside such a model.
    static constexpr std::size_t kDefaultLimit = 1'000'000'000;  // bytes

    // Adds a step and drops the steps that could be redone, and the oldest ones if the limit is
    // exceeded. Throws std::bad_alloc; neither the step nor the history has changed then.
    void add(Step&& step);
    // Drops all steps and counts. The limit stays.
    void clear() noexcept;

    std::size_t undo_count() const { return done_; }
    std::size_t redo_count() const { return steps_.size() - done_; }
    // The number of steps that could still be undone if the limit had not dropped them.
    std::size_t lost_undo_count() const { return lost_undos_; }
    // Returns the number of steps that the limit has dropped since the last call.
    std::size_t take_dropped_count() { return std::exchange(dropped_, 0); }
    // The number of the step that led to the present mesh. Dropped steps count, too.
    std::size_t step_number() const { return lost_undos_ + done_; }
    // A number that identifies the present state of the object. Undo and redo go back and forth
    // between such states. Each step that is added, and clear(), lead to a state with a new number,
    // which no state has had before.
    std::uint64_t state_id() const { return done_ > 0 ? steps_[done_ - 1].state_id : first_state_; }

    // Undoes or redoes `count` steps by calling apply(Step&) for each of them, the latest first or
    // the earliest first. Precondition: there are that many.
    template <typename Apply>
    void undo(std::size_t count, Apply apply) {
        for (; count > 0; --count, --done_) visit(steps_[done_ - 1], apply);
        keep_limit();
    }
    template <typename Apply>
    void redo(std::size_t count, Apply apply) {
        for (; count > 0; --count, ++done_) visit(steps_[done_], apply);
        keep_limit();
    }

    // The step that led to the present mesh. Null before the first step, and where the limit has
    // dropped that step. Valid until the history changes.
    const Step* latest() const { return done_ > 0 ? &steps_[done_ - 1].step : nullptr; }
    // The outcome of the step that led to the present mesh.
    const AdaptOutcome& outcome() const { return latest() ? latest()->outcome : first_outcome_; }
    // The same for an outcome that has changed without a step.
    void set_outcome(const AdaptOutcome& outcome) noexcept {
        (done_ > 0 ? steps_[done_ - 1].step.outcome : first_outcome_) = outcome;
    }
    // AdaptOutcome::forget_limits() for all outcomes.
    void forget_limits() noexcept;

    // Sets the limit in bytes; nothing means no limit. From now on the oldest steps that can be
    // undone are dropped until memory_bytes() is within the limit. The newest step is always kept,
    // and so are the steps that can be redone: each of these builds on the one before it, so
    // dropping the oldest would make all of them useless. Cost: O(steps dropped).
    void set_limit(std::optional<std::size_t> limit);
    std::optional<std::size_t> limit() const { return limit_; }

    std::size_t memory_bytes() const { return bytes_; }  // O(1)

  private:
    struct Entry {
        Step step;
        std::size_t bytes = 0;       // of the step when it was last measured
        std::uint64_t state_id = 0;  // of the state after the step
    };

    template <typename Apply>
    void visit(Entry& entry, Apply& apply) {
        apply(entry.step);
        measure(entry);
    }
    void measure(Entry& entry);
    void keep_limit();
    void drop_oldest();
    void drop_last();

    std::deque<Entry> steps_;
    std::size_t done_ = 0;  // steps_[0, done_) are done, the others undone
    std::size_t lost_undos_ = 0;
    std::size_t dropped_ = 0;        // by the limit, not yet reported
    AdaptOutcome first_outcome_;     // of the mesh before the first step
    std::uint64_t first_state_ = 0;  // before the first step
    std::uint64_t last_state_ = 0;   // the number that was given last
    std::size_t bytes_ = 0;          // of all steps
    std::optional<std::size_t> limit_ = kDefaultLimit;
};

}  // namespace pectin

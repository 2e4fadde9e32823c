// Undo and redo: the commands that changed the object, with what each did, within a limit of
// memory.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "command/command.h"
#include "mesh/mesh_change.h"

namespace pectin {

// Where adaptive meshing stopped short, for the mesh as a step left it.
struct AdaptOutcome {
    bool floor_hit = false, budget_hit = false;
    std::vector<EdgeId> blocked{};  // sorted; see Refinement::blocked
};

class History {
  public:
    struct Step {
        Command command;
        MeshChange change;
        AdaptOutcome outcome;
        // Of a bake, which renames everything: the mesh before it, or once undone, after it.
        std::unique_ptr<TriMesh> exchanged{};

        std::size_t memory_bytes() const;
    };

    // A thousand drags of ten thousand vertices each, or fifteen of all of a 1.3 M face model, and
    // no more than a machine of 4 GB can spare beside such a model.
    static constexpr std::size_t kDefaultLimit = 1'000'000'000;  // bytes

    // A new step drops what could be redone. Where the limit is exceeded the oldest steps are
    // dropped.
    // Where there is no memory it throws, and neither the step nor the history has changed.
    void add(Step&& step);
    // Starts anew; the limit stays.
    void clear();

    std::size_t undo_count() const { return done_; }
    std::size_t redo_count() const { return steps_.size() - done_; }
    // How many more steps there would be to undo, had the limit not dropped them.
    std::size_t lost_undo_count() const { return lost_undos_; }
    // How many steps the limit has dropped since this was last called.
    std::size_t take_dropped_count() { return std::exchange(dropped_, 0); }
    // Of the step that led to the mesh as it is, counted from the beginning whatever was dropped.
    std::size_t step_number() const { return lost_undos_ + done_; }

    // Takes steps back, or does them again: apply(Step&) has the mesh follow, latest first or
    // earliest first. Precondition: there are as many.
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

    // Of the step that led to the mesh as it is.
    const AdaptOutcome& outcome() const {
        return done_ > 0 ? steps_[done_ - 1].step.outcome : first_outcome_;
    }
    // Other settings: where a step stopped by the old ones means nothing any more.
    void forget_outcomes();

    // In bytes; none: no limit. Holds at once and from now on: the oldest steps that can be undone
    // are dropped until memory_bytes() is within it. Two things are kept beyond the limit: the
    // newest step, and the steps that can be redone. Each of these builds on the one before it, so
    // dropping the oldest would make all of them useless. Cost: O(steps dropped).
    void set_limit(std::optional<std::size_t> limit);
    std::optional<std::size_t> limit() const { return limit_; }

    std::size_t memory_bytes() const { return bytes_; }  // O(1)

  private:
    struct Entry {
        Step step;
        std::size_t bytes = 0;  // of the step as it was last measured
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
    std::size_t done_ = 0;  // steps_[0, done_) are in the mesh
    std::size_t lost_undos_ = 0;
    std::size_t dropped_ = 0;     // by the limit, and not reported yet
    AdaptOutcome first_outcome_;  // of the mesh that undoing all leads to
    std::size_t bytes_ = 0;       // of all steps and the first outcome
    std::optional<std::size_t> limit_ = kDefaultLimit;
};

}  // namespace pectin

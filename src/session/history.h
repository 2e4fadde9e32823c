// Undo and redo: the commands that changed the object, with what each did.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
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
    };

    // A new step drops what could be redone.
    void add(Step step);
    void clear();

    std::size_t undo_count() const { return done_; }
    std::size_t redo_count() const { return steps_.size() - done_; }

    // The step to take back or to do again, which then counts as undone or done; the caller
    // applies its change. Precondition: there is one.
    Step& step_back();
    Step& step_forward();
    // The step that led to the mesh as it is; none at the beginning.
    const Step* latest() const { return done_ > 0 ? &steps_[done_ - 1] : nullptr; }

    // Other settings: where a step stopped by the old ones means nothing any more.
    void forget_outcomes();

    std::size_t memory_bytes() const;

  private:
    std::vector<Step> steps_;
    std::size_t done_ = 0;  // steps_[0, done_) are in the mesh
};

}  // namespace pectin

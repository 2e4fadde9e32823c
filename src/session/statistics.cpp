// The values of the stats command.
#include "adapt/adapt.h"
#include "session/input_summary.h"
#include "session/measure.h"
#include "session/session_state.h"

namespace pectin {

Statistics Session::State::statistics() const {
    Statistics s;
    measure(*mesh, s);
    s.input = input_counts(input_report, read_report);
    s.last = last;
    s.error = outcome.error;
    s.divergence_max_deg = largest_divergence_degrees(*mesh);
    const bool has_frame = active_gesture && active_gesture->gesture;
    const Assessment assessment =
        has_frame ? active_gesture->gesture->assessment() : outcome.assessment;
    s.needing_refinement = assessment.needing_refinement;
    s.held_back = assessment.held_back;
    s.floor_hit = outcome.floor_hit;
    s.budget_hit = outcome.budget_hit;
    s.drag_budget_hit = outcome.drag_budget_hit;
    s.folded_vertices = folded;
    s.memory_bytes =
        mesh->memory_bytes() + active->memory_bytes() + history.memory_bytes() +
        (tree ? tree->memory_bytes() : 0) +
        (active_gesture && active_gesture->gesture ? active_gesture->gesture->memory_bytes() : 0);
    s.undo_steps = history.undo_count();
    s.undo_bytes = history.memory_bytes();
    return s;
}

}  // namespace pectin

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
    const Criteria criteria(limits_in_use(), zones_in_use, {});
    const Assessment assessment = assess(*active, criteria, outcome.blocked);
    s.divergence_max_deg = assessment.divergence_max_deg;
    const bool has_ended = outcome.has_ended_at_budget();
    s.needing_refinement = has_ended ? 0 : assessment.needing_refinement;
    s.held_back = assessment.held_back + (has_ended ? assessment.needing_refinement : 0);
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

// Adaptive meshing of an active set: refinement, then decimation.
//
// With the tests and guards of Criteria this terminates, is a fixed point (run again at once it
// does nothing), is reversible (all limits off: the base mesh again) and leaves no edge that
// needs refinement and may be split, as long as the budget is not hit.
#pragma once

#include <span>

#include "adapt/decimate.h"
#include "adapt/refine.h"

namespace pectin {

struct Adaptation {
    Refinement refinement;
    Decimation decimation;
    double refine_seconds = 0.0, decimate_seconds = 0.0;
};

Adaptation adapt(ActiveSet& active, Embedding& embedding, const Criteria& criteria);

// The same for a warp that folds nothing, until no active face cuts another (see SelfIntersections)
// but where floor, budget or the end of the search forbid (Refinement::self_intersections); then
// thins as far as that stays so. Without steps nothing can have come to cut, and only the thinning
// takes care. Without a flatness limit, which says that places matter, it thins as adapt() does.
// Cost: in addition O(n log n) in the active faces, then O(cuts * steps) for each of some rounds.
Adaptation adapt_without_self_intersections(ActiveSet& active, Embedding& embedding,
                                            const Criteria& criteria);

// An edge scan without edits: what the whole mesh looks like to the criteria. Edges along a cut
// count as one.
struct Assessment {
    std::uint64_t needing_refinement = 0;  // edges that need it and may be split
    std::uint64_t held_back = 0;           // edges that need it but may not
    double divergence_max_deg = 0.0;       // over edges with a deformed end
};

// `active` may be idle: rest is then the present. `blocked`: sorted edges that refinement found
// blocked (Refinement::blocked); where they still need it they are held back. Cost: O(n).
Assessment assess(const ActiveSet& active, const Criteria& criteria,
                  std::span<const EdgeId> blocked);

}  // namespace pectin

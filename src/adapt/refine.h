// Refinement: splits edges until none that may be split needs it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "adapt/criteria.h"
#include "embedding/embedding.h"
#include "mesh/active_set.h"

namespace pectin {

// Why adapt_without_self_intersections has left faces that intersect each other.
enum class IntersectionLimit : std::uint8_t {
    none,        // it has left none
    floor,       // the edges to split are as short as they may be
    budget,      // there are as many triangles as there may be
    search,      // looking for them was ended
    decimation,  // without a flatness limit vertices were removed all the same
};

struct Refinement {
    std::uint64_t splits = 0;
    std::uint64_t concurrent_splits = 0;  // of these, with others at the same time
    std::uint64_t chain_steps = 0;        // edges whose neighbours propagation has compared
    bool floor_hit = false;
    bool budget_hit = false;
    // Edges that needed it and are above the floor, but lie beside one that the floor keeps from
    // being split and would leave too thin a triangle; some may have been split since.
    std::vector<EdgeId> blocked;
    std::uint64_t self_intersections = 0;  // that adapt_without_self_intersections has to leave
    IntersectionLimit intersection_limit = IntersectionLimit::none;
};

// A queue by decreasing deformed length (in octaves of its square; within one, where few wait,
// first come, first served): take edges from it, look again whether they need refinement, split
// them at their midpoints, test the edges round the new vertices (Gain & Dodgson 1999, section 4).
// That goes in batches, so that memory is walked through once; an edge that a split makes waits for
// the next batch, also where it is longer. Where thousands wait, batches come from several parts of
// the surface and go on up to four threads (ConcurrentSplits). The same comes out on any number.
//
// Before an edge is split, any edge of its two faces that is more than rho times as long at rest
// is split first, repeatedly (longest-edge propagation, Rivara 1984); such chains end, since they
// go by rest lengths, which halve exactly. An edge whose halves would be below the floor is never
// split, nor waited for, as long as the triangles beside it do not become slivers at rest.
//
// Cost: O(active edges + splits).
Refinement refine(ActiveSet& active, Embedding& embedding, const Criteria& criteria);

// The same, but starts from these edges alone (representatives of their siblings, each once), which
// are split whether they need it or not. Cost: O(edges + splits).
Refinement refine_at(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                     std::span<const EdgeId> edges);

}  // namespace pectin

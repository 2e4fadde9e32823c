// Decimation: undoes splits where the surface has become flat.
#pragma once

#include <cstdint>

#include "adapt/criteria.h"
#include "mesh/active_set.h"

namespace pectin {

class SelfIntersections;

struct Decimation {
    std::uint64_t unsplits = 0;
    std::uint64_t concurrent_unsplits = 0;  // of these, together with others of their level
};

// The active vertices by level, highest first, so that later refinements go before earlier ones
// (Gain & Dodgson 1999, section 4, figure 6). A vertex goes if it is the midpoint its split left,
// with four edges (three on a boundary), neighbours at its level or lower, all edges pass the
// decimation test, the merged edge would not need refinement, and it lies flat.
//
// Two inserted vertices of one level are never neighbours (a midpoint's level is above those of
// all its neighbours), so neither the order within a level matters nor can removing one change
// what another of its level or above sees: one pass is enough, and where a level has thousands it
// goes on up to four threads (ConcurrentUnsplits).
//
// self_intersections: none goes whose restored faces would intersect. That does depend on the
// order; where removing others may have made room, it is tried again. Cost: O(active vertices),
// with cuts times O(log n) for those that could go.
Decimation decimate(ActiveSet& active, const Criteria& criteria,
                    SelfIntersections* self_intersections = nullptr);

}  // namespace pectin

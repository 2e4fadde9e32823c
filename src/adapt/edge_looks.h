// What refinement asks of an edge before and after splits.
#pragma once

#include <array>
#include <cstdint>

#include "adapt/criteria.h"
#include "adapt/refinement_queue.h"
#include "mesh/active_set.h"

namespace pectin {

// Changes nothing, so that several threads may look. All costs O(1).
class EdgeLooks {
  public:
    // The octave of an edge that waits, or why it does not.
    static constexpr std::uint16_t kFine = 0xffff, kBelowFloor = 0xfffe;
    using Octaves = std::array<std::uint16_t, 4>;

    EdgeLooks(const ActiveSet& active, const Criteria& criteria)
        : active_(active), mesh_(active.mesh()), criteria_(criteria) {}

    // Of an edge taken from the queue: it may have been split since, or lie outside the zone now.
    bool still_needs_split(EdgeId e, std::size_t octave) const {
        const double length = mesh_.squared_length(e);
        return RefinementQueue::octave_of(length) == octave &&
               !criteria_.is_below_floor(length) &&  // a half, bent as long as the whole
               criteria_.needs_refinement(active_, e);
    }

    std::uint16_t octave_of(EdgeId e) const {
        const double length = mesh_.squared_length(e);
        if (criteria_.is_below_floor(length)) return kBelowFloor;
        return static_cast<std::uint16_t>(RefinementQueue::octave_of(length));
    }

    // Of the edges round an inserted vertex that has been placed; most look fine.
    Octaves look_round(const ActiveSet::Inserted& made) const {
        Octaves octaves{};
        for (std::size_t k = 0; k < made.edges.size(); ++k) {
            octaves[k] = look_at_new(made.edges[k], k >= 2 || made.is_one_look);
        }
        return octaves;
    }

  private:
    std::uint16_t look_at_new(EdgeId e, bool is_one_look) const {
        if (!exists(e)) return kFine;
        if (is_one_look && criteria_.looks_fine(mesh_, e, true)) return kFine;
        return criteria_.needs_refinement(active_, e) ? octave_of(e) : kFine;
    }

    const ActiveSet& active_;
    const TriMesh& mesh_;
    const Criteria& criteria_;
};

}  // namespace pectin

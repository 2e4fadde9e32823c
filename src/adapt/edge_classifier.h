// What refinement asks of an edge before and after splits.
#pragma once

#include <cstdint>

#include "adapt/criteria.h"
#include "adapt/refinement_queue.h"
#include "mesh/active_set.h"

namespace pectin {

// Changes nothing, so that several threads may look. All costs O(1).
class EdgeClassifier {
  public:
    // In place of the octave of an edge, where the floor keeps it from being split.
    static constexpr std::uint16_t kBelowFloor = 0xfffe;

    EdgeClassifier(const ActiveSet& active, const Criteria& criteria)
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

    // visit(edge, octave or kBelowFloor): the edges that need refinement after a split, once the
    // inserted vertex has been embedded. These are edges at that vertex, and edges of its faces.
    template <typename Visit>
    void classify_one_ring(const ActiveSet::Inserted& made, Visit visit) const {
        for (std::size_t k = 0; k < made.edges.size(); ++k) {
            const EdgeId e = made.edges[k];
            if (!exists(e)) continue;
            const bool is_smooth = k >= 2 || made.is_smooth;
            if (is_smooth && criteria_.satisfies_criteria_fast(mesh_, e, false)) continue;
            if (criteria_.bends_too_far(active_, e)) visit(e, octave_of(e));
        }
        if (!criteria_.limits_length()) return;
        // Each new face has one spoke, the second pair of edges.
        for (std::size_t k = 2; k < made.edges.size(); ++k) {
            if (!exists(made.edges[k])) continue;
            mesh_.for_each_side(made.edges[k], [&](HalfEdgeId h) { visit_coarse(h, visit); });
        }
    }
    // What has to be split because of e: nothing, e itself, or another edge of a face that is too
    // coarse since e is long. The last is found only where that edge is not long itself, and so
    // would pass for one that satisfies the criteria.
    enum Need : std::uint8_t { kNone, kItself, kAnother };
    Need classify(EdgeId e) const {
        if (criteria_.bends_too_far(active_, e)) return kItself;
        Need need = kNone;
        if (!criteria_.limits_length()) return need;
        mesh_.for_each_side(e, [&](HalfEdgeId h) {
            if (need == kItself || !criteria_.is_too_coarse(active_, h)) return;
            const HalfEdgeId first = criteria_.edge_to_split(active_, h);
            if (first == h) {
                need = kItself;
            } else if (!criteria_.is_long(mesh_, mesh_.edge(first))) {
                need = kAnother;
            }
        });
        return need;
    }
    // visit(edge, octave or kBelowFloor): the other edges that classify(e) means.
    template <typename Visit>
    void for_each_needed_adjacent(EdgeId e, Visit visit) const {
        mesh_.for_each_side(e, [&](HalfEdgeId h) {
            visit_coarse(h, [&](EdgeId first, std::uint16_t octave) {
                if (first != e && !criteria_.is_long(mesh_, first)) visit(first, octave);
            });
        });
    }
    // At most so many edges are visited after a split in one sheet.
    static constexpr std::size_t kMaxNeeded = 8;

  private:
    template <typename Visit>
    void visit_coarse(HalfEdgeId h, Visit visit) const {
        if (!criteria_.is_too_coarse(active_, h)) return;
        const EdgeId e = mesh_.edge(criteria_.edge_to_split(active_, h));
        visit(e, octave_of(e));
    }

    const ActiveSet& active_;
    const TriMesh& mesh_;
    const Criteria& criteria_;
};

}  // namespace pectin

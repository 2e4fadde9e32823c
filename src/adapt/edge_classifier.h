// Which edges wait for a split, before and after splits, and in which length class.
#pragma once

#include <cstdint>

#include "adapt/criteria.h"
#include "adapt/refinement_queue.h"
#include "mesh/active_set.h"

namespace pectin {

// Changes nothing, so several threads may use it at a time. All calls cost O(1) for each side.
class EdgeClassifier {
  public:
    // Stands for the length class of an edge that the floor keeps from being split.
    static constexpr std::uint16_t kBelowFloor = 0xfffe;

    EdgeClassifier(const ActiveSet& active, const Criteria& criteria)
        : active_(active), mesh_(active.mesh()), criteria_(criteria) {}

    // Whether an edge taken from the queue has to be split now. It may have been split since it was
    // queued, so that its id stands for one of its halves, or its faces may meet the zone no more.
    bool still_needs_split(EdgeId e, std::size_t length_class) const {
        const double squared_length = mesh_.squared_length(e);
        return RefinementQueue::length_class_of(squared_length) == length_class &&
               !criteria_.is_below_floor(squared_length) && criteria_.needs_refinement(active_, e);
    }

    std::uint16_t length_class_of(EdgeId e) const {
        const double squared_length = mesh_.squared_length(e);
        if (criteria_.is_below_floor(squared_length)) return kBelowFloor;
        return static_cast<std::uint16_t>(RefinementQueue::length_class_of(squared_length));
    }

    //          a        The split of bc inserted m. Calls visit(edge, length class or kBelowFloor)
    //         /|\       for the edges that need refinement now. Refinement condition (a) is tested
    //        / | \      for bm, mc, am and dm alone if it depends on the ends of an edge, otherwise
    //       b--m--c     also for the four outer edges. Refinement condition (b) is tested for every
    //        \ | /      edge of the faces at m, since it depends on faces. An edge may be visited
    //         \|/       twice. Precondition: m has been embedded.
    //          d
    template <typename Visit>
    void classify_one_ring(const ActiveSet::Inserted& made, Visit visit) const {
        if (criteria_.curvature_tests_faces()) {
            visit_new_faces(made, [&](HalfEdgeId h) { visit_curved(h, visit); });
        } else {
            visit_new_edges(made, visit);
        }
        if (criteria_.curvature_depends_on_faces()) visit_outer_edges(made, visit);
        if (!criteria_.length().is_on()) return;
        visit_new_faces(made, [&](HalfEdgeId h) { visit_needed(h, visit); });
    }
    // A split calls visit at most this often for each sheet, without outer edges.
    static constexpr std::size_t kMaxNeeded = 8;

    // Calls visit(edge, length class or kBelowFloor) for the other edges of e's faces that have to
    // be split because of e, where Criteria::need() says SplitNeed::neighbour.
    template <typename Visit>
    void for_each_needed_neighbour(EdgeId e, Visit visit) const {
        mesh_.for_each_side(e, [&](HalfEdgeId h) {
            visit_needed(h, [&](EdgeId first, std::uint16_t length_class) {
                if (first != e && !criteria_.length().is_long(mesh_, first))
                    visit(first, length_class);
            });
        });
    }

    // Calls visit(edge, length class or kBelowFloor) for the edge at which the face of h has to be
    // split by refinement condition (a), if that is a condition for faces.
    template <typename Visit>
    void visit_curved(HalfEdgeId h, Visit visit) const {
        const HalfEdgeId first = criteria_.curvature_needed_split(active_, h);
        if (exists(first)) visit(mesh_.edge(first), length_class_of(mesh_.edge(first)));
    }

  private:
    template <typename Visit>
    void visit_new_edges(const ActiveSet::Inserted& made, Visit visit) const {
        for (std::size_t k = 0; k < made.edges.size(); ++k) {
            const EdgeId e = made.edges[k];
            if (!exists(e)) continue;
            const bool is_smooth = k >= 2 || made.is_smooth;
            if (is_smooth && criteria_.satisfies_criteria_fast(mesh_, e, false)) continue;
            if (criteria_.curvature_needs_refinement(active_, e)) visit(e, length_class_of(e));
        }
    }

    // visit(a half-edge): each new face has one of the edges am and dm, the second pair.
    template <typename Visit>
    void visit_new_faces(const ActiveSet::Inserted& made, Visit visit) const {
        for (std::size_t k = 2; k < made.edges.size(); ++k) {
            if (exists(made.edges[k])) mesh_.for_each_side(made.edges[k], visit);
        }
    }

    // The edges ab, ca, bd and dc by refinement condition (a).
    template <typename Visit>
    void visit_outer_edges(const ActiveSet::Inserted& made, Visit visit) const {
        const VertexId m = active_.vertex(made.vertex_entry);
        for (std::size_t k = 2; k < made.edges.size(); ++k) {
            if (!exists(made.edges[k])) continue;
            mesh_.for_each_side(made.edges[k], [&](HalfEdgeId h) {
                const bool leaves_m = mesh_.origin(h) == m;
                const EdgeId outer = mesh_.edge(leaves_m ? TriMesh::next(h) : TriMesh::prev(h));
                if (criteria_.curvature_needs_refinement(active_, outer))
                    visit(outer, length_class_of(outer));
            });
        }
    }

    template <typename Visit>
    void visit_needed(HalfEdgeId h, Visit visit) const {
        const HalfEdgeId first = criteria_.length().needed_split(active_, h);
        if (exists(first)) visit(mesh_.edge(first), length_class_of(mesh_.edge(first)));
    }

    const ActiveSet& active_;
    const TriMesh& mesh_;
    const Criteria& criteria_;
};

}  // namespace pectin

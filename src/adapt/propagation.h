// Longest-edge propagation: the edges that have to be split before a given edge.
//
// Source: M.-C. Rivara. Algorithms for refining triangular grids suitable for adaptive and
// multigrid techniques. International Journal for Numerical Methods in Engineering 20 (1984).
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "adapt/criteria.h"
#include "adapt/split_order.h"
#include "mesh/active_set.h"

namespace pectin {

// Before an edge is split, any edge of its faces that is more than rho times as long at rest is
// split first (AdaptLimits::propagation), and so on from that edge. With rho = 1 every edge is the
// longest of both its faces when it is split. An edge that may not be split is not waited for.
// Lengths are those at rest, so that chains end (see refine.h).
class Propagation {
  public:
    // Whether an edge may be split. It may embed the vertices inserted so far, as all that
    // propagation reads itself is at rest.
    using MaySplit = std::function<bool(EdgeId)>;
    Propagation(ActiveSet& active, const AdaptLimits& limits, MaySplit may_split)
        : active_(active),
          order_(limits.propagation, limits.symmetry),
          may_pass_longer_(limits.symmetry.has_value()),
          may_split_(std::move(may_split)) {}

    // Appends to the chain the edge that has to be split before its last edge, and so on, until
    // nothing precedes the last edge. Returns true if that one must not be split either, since it
    // would leave too thin a triangle beside an edge that is not waited for. All edges of such a
    // chain are remembered as dead ends until mesh_has_changed(). Precondition: the chain is not
    // empty. Cost: O(edges appended).
    bool extend(std::vector<EdgeId>& chain);
    // To be called after each split and after concurrent splits.
    void mesh_has_changed() {
        if (!dead_ends_.empty()) dead_ends_ = {};
    }
    // The number of edges that were compared with their neighbours so far.
    std::uint64_t steps() const { return steps_; }

  private:
    // The edge to be split before a given edge, or that edge itself. any_blocked: a longer edge may
    // have been passed over. False only if there is none.
    struct Next {
        EdgeId edge;
        bool any_blocked = false;
    };
    Next first_neighbour(EdgeId e);
    bool is_too_thin_beside_blocked(EdgeId e);
    bool halves_are_too_thin(HalfEdgeId h);

    template <typename Visit>
    void for_each_neighbour(EdgeId e, Visit visit) const {
        const TriMesh& mesh = active_.mesh();
        mesh.for_each_side(e, [&](HalfEdgeId h) {
            visit(mesh.edge(TriMesh::next(h)));
            visit(mesh.edge(TriMesh::prev(h)));
        });
    }
    double rest_length(EdgeId e) { return static_cast<double>(active_.rest_length(e)); }
    RestEdge rest_edge(EdgeId e) { return order_.rest_edge(active_, e, rest_length(e)); }

    ActiveSet& active_;
    SplitOrder order_;
    bool may_pass_longer_;  // with symmetry on, edges between mirrored ends precede longer ones
    MaySplit may_split_;
    std::uint64_t steps_ = 0;
    std::unordered_set<EdgeId> dead_ends_;  // edges whose chains end where no split is allowed
};

}  // namespace pectin

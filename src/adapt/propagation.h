// Longest-edge propagation: what has to be split before an edge.
// Source: Rivara 1984; lengths are those at rest, so that chains end.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "adapt/split_order.h"
#include "mesh/active_set.h"

namespace pectin {

// Before an edge is split, any edge of its faces that is more than rho times as long at rest is
// split first (AdaptLimits::propagation), repeatedly. An edge that may not be split is not waited
// for. All it asks of the mesh is at rest; may_split may place what has been split so far.
class Propagation {
  public:
    using MaySplit = std::function<bool(EdgeId)>;
    Propagation(ActiveSet& active, const AdaptLimits& limits, MaySplit may_split)
        : active_(active),
          order_(limits),
          may_pass_longer_(limits.symmetry.has_value()),
          may_split_(std::move(may_split)) {}

    // From the last edge of the chain to the neighbour that precedes it, and on from there, until
    // nothing precedes the last edge. Whether splitting that one leaves too thin a face, beside an
    // edge that is not waited for. Precondition: the chain is not empty. Cost: O(edges added).
    // Where it does, all edges of the chain are remembered to lead there, until mesh_has_changed().
    bool extend(std::vector<EdgeId>& chain);
    void mesh_has_changed() {
        if (!dead_ends_.empty()) dead_ends_ = {};
    }
    // How many edges have been compared with their neighbours.
    std::uint64_t steps() const { return steps_; }

  private:
    // An edge that goes before another, or that other one, and whether longer ones are not waited
    // for then (at least: there may be none).
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
    bool may_pass_longer_;  // with symmetry on, by edges between mirrored ends
    MaySplit may_split_;
    std::uint64_t steps_ = 0;
    std::unordered_set<EdgeId> dead_ends_;  // edges whose chains end where nothing may be split
};

}  // namespace pectin

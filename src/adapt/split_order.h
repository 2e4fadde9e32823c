// The order of splits: which of two edges is split first.
//
// Source: M.-C. Rivara. Algorithms for refining triangular grids suitable for adaptive and
// multigrid techniques. International Journal for Numerical Methods in Engineering 20 (1984).
#pragma once

#include <cmath>
#include <optional>

#include "adapt/floor.h"
#include "ffd/symmetry.h"
#include "mesh/active_set.h"

namespace pectin {

// An edge at rest, which need not exist yet: its length and its ends in either order. Without
// symmetry the order depends on lengths alone, and the ends may be left out.
struct RestEdge {
    double length = 0.0;
    Vec3 b{0.0}, c{0.0};
};

// The edge that is longer at rest precedes the other. This is the only place that decides it.
//
// With symmetry on, ties are broken by the position of the edges, in an order that is the same for
// mirrored edges. An edge between mirrored ends then precedes all others: if it were split later,
// the triangles beside it would be divided by a diagonal, which is not symmetric. All calls cost
// O(1).
class SplitOrder {
  public:
    // propagation: rho in [1, 1.5), see Propagation.
    SplitOrder(double propagation, const std::optional<MirrorPlane>& symmetry)
        : propagation_(propagation), symmetry_(symmetry) {}

    // Whether `candidate` has to be split before e, which is itself to be split.
    bool propagates(const RestEdge& candidate, const RestEdge& e) const {
        return precedes(candidate, e, propagation_);
    }
    // Of two edges that have to be split before a third one: whether this one comes first.
    bool precedes(const RestEdge& candidate, const RestEdge& other) const {
        return precedes(candidate, other, 1.0);
    }
    // The same without symmetry, by lengths at rest.
    static bool precedes(double candidate, double other) { return candidate > other; }
    // Whether a face may be split at an edge of length e beside an edge of length `candidate`: that
    // one is at most rho times as long.
    bool fits_beside(double candidate, double e) const { return candidate <= propagation_ * e; }
    // The same, and `candidate` does not have to be split first either.
    bool fits_beside(const RestEdge& candidate, const RestEdge& e) const {
        return fits_beside(candidate.length, e.length) && !propagates(candidate, e);
    }

    // The edge of the face of h that precedes the other two, as a half-edge of that face. Edges
    // that the floor keeps from being split count only if it keeps all three. The answer is the
    // same for each half-edge of the face; of equally long edges without symmetry it is the one at
    // the lowest corner.
    HalfEdgeId first_edge(const ActiveSet& active, HalfEdgeId h, const Floor& floor) const;

    // length: the rest length of e.
    RestEdge rest_edge(const ActiveSet& active, EdgeId e, double length) const {
        if (!symmetry_) return {length};
        const HalfEdgeId h = active.mesh().half_edge(e);
        return {length, active.rest_position(active.mesh().origin(h)),
                active.rest_position(active.mesh().target(h))};
    }

  private:
    // Two points are mirror images of each other if they miss by at most this fraction of the
    // length of the edge between them. Rounding is far smaller.
    static constexpr double kSameImage = 1e-6;
    // Tells apart the midpoints of edges of equal length. The direction has no regularity, so that
    // neither the points of a regular mesh nor their rounding project to the same value.
    static constexpr Vec3 kGenericDirection{0.7390851332151607, 0.4142135623730951,
                                            0.5671432904097838};

    template <typename Edge>
    HalfEdgeId first_edge(const ActiveSet& active, HalfEdgeId h, const Floor& floor) const;
    bool precedes(const RestEdge& candidate, const RestEdge& e, double factor) const {
        if (!symmetry_) return candidate.length > factor * e.length;
        const bool spans = is_between_images(candidate);
        if (spans != is_between_images(e)) return spans;
        if (candidate.length != e.length) return candidate.length > factor * e.length;
        return folded_key(candidate) > folded_key(e);
    }
    bool is_between_images(const RestEdge& e) const {
        return glm::distance(symmetry_->image(e.b), e.c) <= kSameImage * e.length;
    }
    // A number that tells midpoints apart and is the same for mirrored ones: the midpoint is moved
    // to the positive side of the plane first.
    double folded_key(const RestEdge& e) const {
        Vec3 middle = e.b + e.c;
        middle[symmetry_->axis] = std::abs(middle[symmetry_->axis] - 2.0 * symmetry_->at);
        return glm::dot(middle, kGenericDirection);
    }

    double propagation_;
    std::optional<MirrorPlane> symmetry_;
};

}  // namespace pectin

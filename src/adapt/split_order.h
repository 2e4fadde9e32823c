// Which of the edges of a face is split first.
// Source: longest-edge propagation, Rivara 1984; lengths are those at rest.
#pragma once

#include <cmath>

#include "adapt/criteria.h"
#include "mesh/active_set.h"

namespace pectin {

// An edge at rest, which may have yet to be made: its length and its ends, in either order. The
// ends are left out where there is no symmetry.
struct RestEdge {
    double length = 0.0;
    Vec3 b{0.0}, c{0.0};
};

// The longer goes first. With symmetry on, ties are broken by geometry instead of by who comes
// first, in an order that mirrored edges have in common. An edge between mirrored ends goes before
// all others then: the triangles beside it would have to be cut by a diagonal, on one side or the
// other. All O(1).
class SplitOrder {
  public:
    explicit SplitOrder(const AdaptLimits& limits) : limits_(limits) {}

    // Whether `candidate` goes before e, which is to be split itself.
    bool propagates(const RestEdge& candidate, const RestEdge& e) const {
        return precedes(candidate, e, limits_.propagation);
    }
    // Of two that do, whether this one goes before that.
    bool precedes(const RestEdge& candidate, const RestEdge& other) const {
        return precedes(candidate, other, 1.0);
    }
    // Whether it is no more than rho times as long, so that the face may well be split at e. Edges
    // between mirrored ends do not wait for that.
    bool fits_beside(double candidate, double e) const {
        return candidate <= limits_.propagation * e;
    }
    // And does not go before it.
    bool fits_beside(const RestEdge& candidate, const RestEdge& e) const {
        return fits_beside(candidate.length, e.length) && !propagates(candidate, e);
    }

    // length: at rest. Of an edge that is there.
    RestEdge rest_edge(const ActiveSet& active, EdgeId e, double length) const {
        if (!limits_.symmetry) return {length};
        const HalfEdgeId h = active.mesh().half_edge(e);
        return {length, active.rest_position(active.mesh().origin(h)),
                active.rest_position(active.mesh().target(h))};
    }

  private:
    // An end of an edge is the image of the other if it is off by no more than this share of it.
    static constexpr double kSameImage = 1e-6;
    // Tells apart the middles of edges that are equally long: no two of a regular mesh, and no
    // rounding of their coordinates, come out even in a direction without any regularity.
    static constexpr Vec3 kGenericDirection{0.7390851332151607, 0.4142135623730951,
                                            0.5671432904097838};

    bool precedes(const RestEdge& candidate, const RestEdge& e, double factor) const {
        if (!limits_.symmetry) return candidate.length > factor * e.length;
        const bool spans = is_between_images(candidate);
        if (spans != is_between_images(e)) return spans;
        if (candidate.length != e.length) return candidate.length > factor * e.length;
        return folded_key(candidate) > folded_key(e);
    }
    bool is_between_images(const RestEdge& e) const {
        return glm::distance(limits_.symmetry->image(e.b), e.c) <= kSameImage * e.length;
    }
    // Of an edge's middle, moved to the plane's positive side; different for different places.
    double folded_key(const RestEdge& e) const {
        const MirrorPlane& plane = *limits_.symmetry;
        Vec3 middle = e.b + e.c;
        middle[plane.axis] = std::abs(middle[plane.axis] - 2.0 * plane.at);
        return glm::dot(middle, kGenericDirection);
    }

    const AdaptLimits& limits_;
};

}  // namespace pectin

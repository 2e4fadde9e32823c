#include "adapt/propagation.h"

#include <algorithm>
#include <cmath>

namespace pectin {
namespace {

// An edge that the floor keeps from being split (where the warp crushes it) is not waited for,
// however long it is at rest. Splitting beside it thins triangles at rest; they may become this
// thin, as twice the area over the square of the longest edge, and no thinner. That their shape
// stays bounded is what makes refinement end: without it, splits beside one crushed edge go on for
// ever. An equilateral triangle has 0.87, and each such split halves it.
constexpr double kThinnestBesideBlocked = 1.0 / 512.0;

// An end of an edge is the image of the other if it is off by no more than this share of the edge.
constexpr double kSameImage = 1e-6;
// Tells apart the middles of edges that are equally long: no two of a regular mesh, and no rounding
// of their coordinates, come out even in a direction without any regularity.
constexpr Vec3 kGenericDirection{0.7390851332151607, 0.4142135623730951, 0.5671432904097838};

}  // namespace

Propagation::Chain Propagation::chain(EdgeId e) {
    while (true) {
        const Next next = longest_neighbour(e);
        if (next.edge == e) return {e, next.any_blocked && is_too_thin_beside_blocked(e)};
        e = next.edge;
    }
}

// The longest of the other edges of e's faces that may be split and is more than rho times as
// long; e itself if there is none.
Propagation::Next Propagation::longest_neighbour(EdgeId e) {
    if (limits_.symmetry) return first_neighbour(e);
    double longest = limits_.propagation * rest_length(e);
    Next next{e};
    for_each_neighbour(e, [&](EdgeId candidate) {
        const double length = rest_length(candidate);
        if (!(length > longest)) return;
        if (may_split_(candidate)) {
            longest = length;
            next.edge = candidate;
        } else {
            next.any_blocked = true;
        }
    });
    return next;
}

// The same with ties broken by geometry instead of by who comes first, in an order that
// mirrored edges have in common. An edge between mirrored ends goes before all others: the
// triangles beside it would have to be cut by a diagonal, on one side or the other.
Propagation::Next Propagation::first_neighbour(EdgeId e) {
    EdgeId found = e;
    for_each_neighbour(e, [&](EdgeId candidate) {
        if (goes_before(candidate, found, found == e) && may_split_(candidate)) {
            found = candidate;
        }
    });
    return {found, true};  // an edge between mirrored ends does not wait for longer ones either
}

bool Propagation::goes_before(EdgeId candidate, EdgeId e, bool by_propagation) {
    const bool spans = is_between_images(candidate);
    if (spans != is_between_images(e)) return spans;
    const double length = rest_length(candidate), other = rest_length(e);
    if (length != other) {
        return length > (by_propagation ? limits_.propagation : 1.0) * other;
    }
    return folded_key(candidate) > folded_key(e);
}

bool Propagation::is_between_images(EdgeId e) {
    const HalfEdgeId h = active_.mesh().half_edge(e);
    const Vec3& b = active_.rest_position(active_.mesh().origin(h));
    const Vec3& c = active_.rest_position(active_.mesh().target(h));
    return glm::distance(limits_.symmetry->image(b), c) <= kSameImage * rest_length(e);
}

// Of an edge's middle, moved to the plane's positive side; different for different places.
double Propagation::folded_key(EdgeId e) const {
    const HalfEdgeId h = active_.mesh().half_edge(e);
    const MirrorPlane& plane = *limits_.symmetry;
    Vec3 middle = active_.rest_position(active_.mesh().origin(h)) +
                  active_.rest_position(active_.mesh().target(h));
    middle[plane.axis] = std::abs(middle[plane.axis] - 2.0 * plane.at);
    return glm::dot(middle, kGenericDirection);
}

// Precondition: nothing goes before e, so no edge more than rho times as long is waited for.
bool Propagation::is_too_thin_beside_blocked(EdgeId e) {
    bool any = false;
    active_.mesh().for_each_side(e, [&](HalfEdgeId h) { any = any || thins_too_far(h); });
    return any;
}

// Whether halving h's face across h leaves it too thin, beside an edge that is longer.
bool Propagation::thins_too_far(HalfEdgeId h) {
    const TriMesh& mesh = active_.mesh();
    const double longest = std::max(rest_length(mesh.edge(TriMesh::next(h))),
                                    rest_length(mesh.edge(TriMesh::prev(h))));
    if (longest <= limits_.propagation * rest_length(mesh.edge(h))) return false;
    const Vec3& a = active_.rest_position(mesh.origin(TriMesh::prev(h)));
    const Vec3& b = active_.rest_position(mesh.origin(h));
    const Vec3& c = active_.rest_position(mesh.target(h));
    return 0.5 * glm::length(glm::cross(c - b, a - b)) < kThinnestBesideBlocked * longest * longest;
}

}  // namespace pectin

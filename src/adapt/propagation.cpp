#include "adapt/propagation.h"

#include <algorithm>

namespace pectin {
namespace {

// An edge that the floor keeps from being split (where the warp crushes it) is not waited for,
// however long it is at rest. Splitting beside it thins triangles at rest; they may become this
// thin, as twice the area over the square of the longest edge, and no thinner. That their shape
// stays bounded is what makes refinement end: without it, splits beside one crushed edge go on for
// ever. An equilateral triangle has 0.87, and each such split halves it.
constexpr double kThinnestBesideBlocked = 1.0 / 512.0;

}  // namespace

bool Propagation::extend(std::vector<EdgeId>& chain) {
    while (true) {
        ++steps_;
        const EdgeId e = chain.back();
        if (dead_ends_.contains(e)) break;
        const Next next = first_neighbour(e);
        if (next.edge != e) {
            chain.push_back(next.edge);
            continue;
        }
        if (!next.any_blocked || !is_too_thin_beside_blocked(e)) return false;
        break;
    }
    dead_ends_.insert(chain.begin(), chain.end());
    return true;
}

// Of the other edges of e's faces that may be split and go before e, the one that goes first; e
// itself if there is none.
Propagation::Next Propagation::first_neighbour(EdgeId e) {
    const RestEdge own = rest_edge(e);
    RestEdge first = own;
    Next next{e, may_pass_longer_};
    for_each_neighbour(e, [&](EdgeId id) {
        const RestEdge candidate = rest_edge(id);
        const bool precedes =
            next.edge == e ? order_.propagates(candidate, own) : order_.precedes(candidate, first);
        if (!precedes) return;
        if (may_split_(id)) {
            first = candidate;
            next.edge = id;
        } else {
            next.any_blocked = true;
        }
    });
    return next;
}

// Precondition: nothing goes before e, so no edge more than rho times as long is waited for.
bool Propagation::is_too_thin_beside_blocked(EdgeId e) {
    bool any = false;
    active_.mesh().for_each_side(e, [&](HalfEdgeId h) { any = any || halves_are_too_thin(h); });
    return any;
}

// Whether halving h's face across h leaves it too thin, beside an edge that is longer.
bool Propagation::halves_are_too_thin(HalfEdgeId h) {
    const TriMesh& mesh = active_.mesh();
    const double longest = std::max(rest_length(mesh.edge(TriMesh::next(h))),
                                    rest_length(mesh.edge(TriMesh::prev(h))));
    if (order_.fits_beside(longest, rest_length(mesh.edge(h)))) return false;
    const Vec3& a = active_.rest_position(mesh.origin(TriMesh::prev(h)));
    const Vec3& b = active_.rest_position(mesh.origin(h));
    const Vec3& c = active_.rest_position(mesh.target(h));
    return 0.5 * glm::length(glm::cross(c - b, a - b)) < kThinnestBesideBlocked * longest * longest;
}

}  // namespace pectin

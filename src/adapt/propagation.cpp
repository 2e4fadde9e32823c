#include "adapt/propagation.h"

#include <algorithm>

namespace pectin {
namespace {

// The 1:512 rule. An edge that the floor keeps from being split, because the warp crushes it, is
// not waited for, however long it is at rest. Splits beside it make triangles thinner at rest.
// Twice the area over the square of the longest edge must not fall below this value, since
// refinement terminates only if shapes are bounded (see refine.h). An equilateral triangle has
// 0.87, and each such split halves the value.
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

// Among the other edges of e's faces that may be split and precede e, the one that precedes the
// others; e itself if there is none.
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

// Whether a split of e would leave too thin a triangle. Precondition: no edge that may be split
// precedes e, so edges more than rho times as long are not waited for.
bool Propagation::is_too_thin_beside_blocked(EdgeId e) {
    bool any = false;
    active_.mesh().for_each_side(e, [&](HalfEdgeId h) { any = any || halves_are_too_thin(h); });
    return any;
}

//          a
//         /|\        The face of h = bc is split into bma and mca. Only a face with an edge that is
//        / | \       too long beside bc is tested: bisections at the longest edge keep shapes
//       b--m--c      bounded by themselves.
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

// Refinement: splits edges until no edge that may be split needs it.
//
// Sources: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4.
// M.-C. Rivara. Algorithms for refining triangular grids suitable for adaptive and multigrid
// techniques. International Journal for Numerical Methods in Engineering 20 (1984).
// I. Rosenberg, F. Stenger. A lower bound on the angles of triangles constructed by bisecting the
// longest side. Mathematics of Computation 29 (1975).
//
// Why refinement terminates
//
// 1. The order of splits is strict. Before an edge is split, any edge of its faces that precedes it
//    is split first (Propagation). "Precedes" compares stored rest lengths by `>`, and ties by
//    position (SplitOrder). A chain of such edges therefore visits no edge twice. It ends, since
//    the mesh has finitely many edges, and then an edge is split. It remains to show that there are
//    finitely many splits.
// 2. A split bisects each face at its edge into two faces of half the rest area. So the faces that
//    can arise from a base face of rest area A form a binary tree, and at depth k they have rest
//    area A / 2^k.
// 3. Shapes at rest are bounded. Let q be twice the area of a face over the square of its longest
//    edge. A bisection at the longest edge never leaves an angle below half of the smallest angle
//    at the start, however often it is repeated (Rosenberg & Stenger 1975), so q stays above a
//    quarter of its value at the start. A face is bisected at another edge only where the floor
//    forbids to split a longer one, or where symmetry puts an edge between mirrored ends first;
//    and only if both halves keep q >= 1/512 (the 1:512 rule in propagation.cpp). So q has a lower
//    bound Q > 0 over all faces, and at depth k no edge is longer at rest than sqrt(2A / (Q 2^k)).
//    A base face without area (q = 0) is bisected at its longest edge only. The median to the
//    longest edge is at most sqrt(3)/2 times as long as that edge, so two such bisections shorten
//    the longest edge to sqrt(3)/2 of its length or less.
// 4. The warp stretches by a bounded factor S, its Lipschitz constant. A deformed edge is at most S
//    times as long as the edge at rest.
// 5. An edge is split only if its deformed length is at least twice the floor. By 3 and 4, no edge
//    at a depth k > log2(A S^2 / (2 Q floor^2)) is that long. So the trees are finite, and so is
//    the number of splits. And the queue empties: an edge is queued by the scan at the beginning,
//    or because of a split, a few for each. A deferred edge is queued again only by a batch in
//    which most edges were split (ConcurrentSplits::split).
// 6. The last resort is the budget, and that levels end (TriMesh::may_split). They also stop what
//    the argument leaves out: a floor of 0; rounding, where S is so large that rest edges are as
//    short as a few units in the last place; and a propagation rho > 1, for which the bound in 3 is
//    not proven (property tests cover rho up to 1.49).
//
// The argument does not need the halves of an edge to be exactly half as long. Stored rest lengths
// are rounded, and midpoints too; the floor is at least 2^10 units in the last place, so that
// rounding changes the length of an edge by less than a thousandth.
//
// Two triangles as an example: the unit square, divided along bc.
//
//     c-------d        c-------d        c---o---d       All of it lies in the zone, there is no
//     |\      |        |\     /|        |\  |  /|       deformation (S = 1), l_max is 0.9 and the
//     | \     |        | \   / |        | \ | / |       floor is 0.1. Both faces are too coarse, as
//     |  \    |        |  \ /  |        |  \|/  |       bc = 1.41, and both are split at bc. The
//     |   \   |  --->  |   m   |  --->  o---m---o       four new faces have a side of the square as
//     |    \  |        |  / \  |        |  /|\  |       longest edge, 1 > 0.9, and are split there.
//     |     \ |        | /   \ |        | / | \ |       The longest edge is 0.71 now, so nothing is
//     |      \|        |/     \|        |/  |  \|       left in the queue after 5 splits.
//     a-------b        a-------b        a---o---b
//
// With l_max = 0.01 the floor decides. All faces are similar to the first ones, with q = 1/2, and
// at depth k their longest edge is sqrt(2) / 2^(k/2). At depth 5 it is 0.25 and is split; at depth
// 6 it is 0.18, which is less than 0.2. There are 2 * 2^6 = 128 faces.
//
// The 1:512 rule is needed where a warp bends bc into a loop whose ends nearly meet. Then bc is
// below the floor, though it is the longest edge at rest, and faces beside it are split elsewhere.
// An inserted vertex may come as close to bc as it likes, and the edges from it to b and c are
// still long, since they cross the loop. Each split halves the area of the face at bc: q is 1/2 for
// abc, 1/4 after the first split, and 1/512 after the eighth. The ninth is refused and reported
// (Refinement::blocked).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "adapt/criteria.h"
#include "embedding/embedding.h"
#include "geometry/stop_token.h"
#include "mesh/active_set.h"

namespace pectin {

// Why adapt_without_self_intersections has left self-intersections.
enum class IntersectionLimit : std::uint8_t {
    none,        // it has left none
    floor,       // the edges to split are as short as the floor allows
    budget,      // the mesh has as many triangles as the budget allows
    search,      // the search was ended, as it took too long; there may be more, or some
    decimation,  // there is no flatness limit, so vertices were removed all the same
};

struct Refinement {
    std::uint64_t splits = 0;
    std::uint64_t concurrent_splits = 0;  // those of `splits` that adapt/concurrent made
    std::uint64_t chain_steps = 0;        // edges that propagation compared with their neighbours
    bool floor_hit = false;
    bool budget_hit = false;
    bool was_stopped = false;  // edges may be left that need refinement
    // Edges above the floor that needed refinement, but would have left too thin a triangle beside
    // an edge that the floor keeps from being split. Some may have been split since.
    std::vector<EdgeId> blocked;
    std::uint64_t self_intersections = 0;  // those that adapt_without_self_intersections has left
    IntersectionLimit intersection_limit = IntersectionLimit::none;
};

// Queues the edges that need refinement, longest first. Repeatedly takes edges from the queue,
// tests them again, splits them at their midpoints, embeds the new vertices and queues those of the
// edges around them that need refinement (Gain & Dodgson 1999, section 4).
//
// Edges are taken in batches, so that memory is walked through once. An edge that a split produces
// waits for a later batch, even if it is longer than the rest of this one. Where thousands wait,
// batches are split on several threads (ConcurrentSplits). The result does not depend on the number
// of threads. Cost: O(active edges + splits).
//
// stop: asked after each batch once something was split, so that repeated calls come to an end.
Refinement refine(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                  const StopToken& stop = {});

// The same, but starts from these edges alone and splits them whether they need it or not. Edges
// along a cut: the representative only. Each at most once. Cost: O(edges + splits).
Refinement refine_at(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                     std::span<const EdgeId> edges, const StopToken& stop = {});

}  // namespace pectin

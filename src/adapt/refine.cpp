#include "adapt/refine.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "adapt/parallel.h"
#include "adapt/refinement_queue.h"
#include "mesh/first_of_siblings.h"

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

class Refiner {
  public:
    Refiner(ActiveSet& active, Embedding& embedding, const Criteria& criteria)
        : active_(active), embedding_(embedding), criteria_(criteria) {}

    Refinement run() {
        push_all_needed();
        split_queued();
        return result_;
    }

    Refinement run_at(std::span<const EdgeId> edges) {
        std::vector<float> lengths;
        for (EdgeId e : edges) lengths.push_back(active_.rest_length(e));
        for (std::size_t i = 0; i < edges.size() && !result_.budget_hit; ++i) {
            // One split since, for the sake of another, is its shorter half now.
            if (active_.rest_length(edges[i]) != lengths[i]) continue;
            if (is_below_floor(active_.mesh().squared_length(edges[i]))) continue;
            split_with_propagation(edges[i]);
        }
        split_queued();
        return result_;
    }

  private:
    void split_queued() {
        while (!result_.budget_hit) {
            const auto next = queue_.pop();
            if (!next) break;
            // An edge split since, for the sake of another, waits again as its shorter half.
            const double length = active_.mesh().squared_length(next->edge);
            if (RefinementQueue::octave_of(length) != next->octave) continue;
            if (!criteria_.needs_refinement(active_, next->edge)) continue;
            if (!is_below_floor(length)) split_with_propagation(next->edge);
        }
    }

    // Looks at the edges on all threads, then queues them in their order. Of those along one cut
    // only the first is looked at, since that looks at all of them.
    void push_all_needed() {
        const TriMesh& mesh = active_.mesh();
        const std::span<const EdgeId> edges = active_.edges();
        const std::span<const std::uint8_t> one_look = active_.one_look_edges();
        const auto count = static_cast<std::uint32_t>(edges.size());
        const auto is_along_cut = [&](EdgeId e) { return mesh.sibling(e) != e; };
        const bool may_be_long = !(embedding_.longest_edge_bound() <= criteria_.limits().l_max);
        const auto needs = [&](std::uint32_t i) {
            const EdgeId e = edges[i];
            if (!mesh.is_live(e)) return false;
            if (one_look[i] != 0 && criteria_.looks_fine(mesh, e, may_be_long)) return false;
            return is_along_cut(e) || criteria_.needs_refinement(active_, e);
        };
        const std::span<std::uint8_t> may_need = active_.scratch_of_edges();
        for_pieces(0, count, [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) may_need[i] = needs(i) ? 1 : 0;
        });
        FirstOfSiblings is_first(mesh);
        for_each_set(may_need, [&](std::size_t i) {
            const EdgeId e = edges[i];
            if (!is_first(e)) return;
            if (is_along_cut(e)) {
                push_if_needed(e);
            } else {
                push(e);
            }
        });
    }

    // visit(index of each byte that is 1), in order.
    template <typename Visit>
    static void for_each_set(std::span<const std::uint8_t> bytes, Visit visit) {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const void* const next = std::memchr(bytes.data() + i, 1, bytes.size() - i);
            if (!next) return;
            i = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - bytes.data());
            visit(i);
        }
    }

    void push_if_needed(EdgeId e) {
        if (criteria_.needs_refinement(active_, e)) push(e);
    }
    // Of an edge that a split has made or halved, most of which look fine.
    void push_new_if_needed(EdgeId e) {
        if (active_.is_one_look(e) && criteria_.looks_fine(active_.mesh(), e, true)) return;
        push_if_needed(e);
    }
    void push(EdgeId e) {
        const double length = active_.mesh().squared_length(e);
        if (!is_below_floor(length)) queue_.push(e, RefinementQueue::octave_of(length));
    }

    bool is_below_floor(double squared_length) {
        const bool below = criteria_.is_below_floor(squared_length);
        result_.floor_hit |= below;
        return below;
    }

    // Splits what has to go before e, then e.
    void split_with_propagation(EdgeId e) {
        while (true) {
            const EdgeId first = end_of_chain(e);
            if (is_too_thin_beside_blocked(first)) {
                active_.mesh().for_each_side(e, [this](HalfEdgeId h) { block(h); });
                result_.floor_hit = true;
                return;
            }
            if (!active_.mesh().may_split(first) || !split(first) || first == e) return;
        }
    }

    // From e to the longest neighbour more than rho times as long at rest, and on from there.
    EdgeId end_of_chain(EdgeId e) {
        while (true) {
            const EdgeId longer = longest_neighbour(e);
            if (longer == e) return e;
            e = longer;
        }
    }

    // The longest of the other edges of e's faces that may be split and is more than rho times as
    // long; e itself if there is none.
    EdgeId longest_neighbour(EdgeId e) {
        if (criteria_.limits().symmetry) return first_neighbour(e);
        double longest = criteria_.limits().propagation * rest_length(e);
        EdgeId found = e;
        for_each_neighbour(e, [&](EdgeId candidate) {
            const double length = rest_length(candidate);
            if (length > longest && may_split(candidate)) {
                longest = length;
                found = candidate;
            }
        });
        return found;
    }

    // The same with ties broken by geometry instead of by who comes first, in an order that
    // mirrored edges have in common. An edge between mirrored ends goes before all others: the
    // triangles beside it would have to be cut by a diagonal, on one side or the other.
    EdgeId first_neighbour(EdgeId e) {
        EdgeId found = e;
        for_each_neighbour(e, [&](EdgeId candidate) {
            if (goes_before(candidate, found, found == e) && may_split(candidate)) {
                found = candidate;
            }
        });
        return found;
    }
    bool goes_before(EdgeId candidate, EdgeId e, bool by_propagation) {
        const bool spans = is_between_images(candidate);
        if (spans != is_between_images(e)) return spans;
        const double length = rest_length(candidate), other = rest_length(e);
        if (length != other) {
            return length > (by_propagation ? criteria_.limits().propagation : 1.0) * other;
        }
        return folded_key(candidate) > folded_key(e);
    }
    bool is_between_images(EdgeId e) {
        const HalfEdgeId h = active_.mesh().half_edge(e);
        const Vec3& b = active_.rest_position(active_.mesh().origin(h));
        const Vec3& c = active_.rest_position(active_.mesh().target(h));
        return glm::distance(criteria_.limits().symmetry->image(b), c) <=
               kSameImage * rest_length(e);
    }
    // Of an edge's middle, moved to the plane's positive side; different for different places.
    double folded_key(EdgeId e) const {
        const HalfEdgeId h = active_.mesh().half_edge(e);
        const MirrorPlane& plane = *criteria_.limits().symmetry;
        Vec3 middle = active_.rest_position(active_.mesh().origin(h)) +
                      active_.rest_position(active_.mesh().target(h));
        middle[plane.axis] = std::abs(middle[plane.axis] - 2.0 * plane.at);
        return glm::dot(middle, kGenericDirection);
    }

    // Once an edge, also where it has two sides.
    void block(HalfEdgeId h) {
        const EdgeId e = active_.mesh().edge(h);
        if (active_.mesh().half_edge(e) == h) result_.blocked.push_back(e);
    }

    // Precondition: e ends its chain, so any edge more than rho times as long is blocked.
    bool is_too_thin_beside_blocked(EdgeId e) {
        bool any = false;
        active_.mesh().for_each_side(e, [&](HalfEdgeId h) { any = any || thins_too_far(h); });
        return any;
    }

    // Whether halving h's face across h leaves it too thin, beside an edge that is longer.
    bool thins_too_far(HalfEdgeId h) {
        const TriMesh& mesh = active_.mesh();
        const double longest = std::max(rest_length(mesh.edge(TriMesh::next(h))),
                                        rest_length(mesh.edge(TriMesh::prev(h))));
        if (longest <= criteria_.limits().propagation * rest_length(mesh.edge(h))) return false;
        const Vec3& a = active_.rest_position(mesh.origin(TriMesh::prev(h)));
        const Vec3& b = active_.rest_position(mesh.origin(h));
        const Vec3& c = active_.rest_position(mesh.target(h));
        return 0.5 * glm::length(glm::cross(c - b, a - b)) <
               kThinnestBesideBlocked * longest * longest;
    }

    template <typename Visit>
    void for_each_neighbour(EdgeId e, Visit visit) const {
        const TriMesh& mesh = active_.mesh();
        mesh.for_each_side(e, [&](HalfEdgeId h) {
            visit(mesh.edge(TriMesh::next(h)));
            visit(mesh.edge(TriMesh::prev(h)));
        });
    }

    double rest_length(EdgeId e) { return static_cast<double>(active_.rest_length(e)); }

    bool may_split(EdgeId e) const {
        return !criteria_.is_below_floor(active_.mesh(), e) && active_.mesh().may_split(e);
    }

    bool split(EdgeId e) {
        const TriMesh& mesh = active_.mesh();
        std::uint64_t added = 0;
        mesh.for_each_side(e, [&](HalfEdgeId) { ++added; });
        if (mesh.face_count() + added > criteria_.limits().budget) {
            result_.budget_hit = true;
            return false;
        }
        const ActiveSet::Inserted inserted = active_.split(e);
        embedding_.place(inserted);
        ++result_.splits;
        for (EdgeId round : inserted.edges) push_new_if_needed(round);
        return true;
    }

    ActiveSet& active_;
    Embedding& embedding_;
    const Criteria& criteria_;
    RefinementQueue queue_;
    Refinement result_;
};

}  // namespace

Refinement refine(ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
    return Refiner(active, embedding, criteria).run();
}

Refinement refine_at(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                     std::span<const EdgeId> edges) {
    return Refiner(active, embedding, criteria).run_at(edges);
}

}  // namespace pectin

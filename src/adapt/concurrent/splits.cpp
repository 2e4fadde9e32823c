#include "adapt/concurrent/splits.h"

#include <type_traits>

#include "geometry/parallel.h"

namespace pectin {

ConcurrentSplits::Result ConcurrentSplits::split(const RefinementQueue::Batch& batch,
                                                 RefinementQueue& queue) {
    const std::size_t entries = active_.vertex_entries();
    if (claims_.entries() < entries) claims_.begin(2 * entries);
    chosen_.resize(active_.edges().size(), 0);
    for (std::size_t i = 0; i < partitions_.size(); ++i) {
        partitions_[i].number = static_cast<CornerClaims::PartitionIndex>(i);
        partitions_[i].edges = batch.partitions[i];
    }
    for_each_concurrently(partitions_, [&](Partition& partition) {
        collect_candidates(partition, batch.length_class);
    });
    for_each_concurrently(partitions_, [&](Partition& partition) { choose(partition); });
    allocate(assign_slots());
    for_each_concurrently(partitions_, [&](Partition& partition) {
        split_chosen(partition);
        release(partition);
    });
    const bool floor_hit = queue_needed(queue);
    defer(queue, batch.length_class);
    return {slots_.ids.size(), floor_hit, deferred_};
}

// Returns whether the floor keeps one of the edges from being split.
bool ConcurrentSplits::queue_needed(RefinementQueue& queue) const {
    bool floor_hit = false;
    for (const Partition& partition : partitions_) {
        for (const auto& [edge, length_class] : partition.needed) {
            if (length_class == EdgeClassifier::kBelowFloor) {
                floor_hit = true;
            } else {
                queue.push(edge, length_class, partition.number);
            }
        }
    }
    return floor_hit;
}

void ConcurrentSplits::defer(RefinementQueue& queue, std::size_t length_class) {
    const bool again = accepted_most();
    for (const Partition& partition : partitions_) {
        PendingSplits& deferred = deferred_[partition.number];
        deferred.partition = partition.number;
        deferred.splits.clear();
        for (const Candidate& candidate : partition.candidates) {
            if (candidate.accepted) continue;
            if (again) {
                queue.push(candidate.edge, length_class, partition.number);
            } else {
                deferred.splits.push_back({candidate.edge, candidate.end});
            }
        }
    }
}

bool ConcurrentSplits::accepted_most() const {
    std::size_t accepted = 0, total = 0;
    for (const Partition& partition : partitions_) {
        accepted += partition.order.size();
        total += partition.candidates.size();
    }
    return 2 * accepted > total;
}

// --- Choosing edges

void ConcurrentSplits::collect_candidates(Partition& partition, std::size_t length_class) {
    partition.candidates.clear();
    for (EdgeId e : partition.edges) {
        if (!classifier_.still_needs_split(e, length_class)) continue;
        partition.candidates.push_back(candidate(e));
        const auto& corners = partition.candidates.back().corners;
        if (corners) claims_.claim(*corners, partition.number);
    }
}

//          a
//         / \        All that a split of bc changes has one of the corners a, b, c and d in common
//        /   \       with it. Edges whose corners are disjoint can be split at the same time.
//       b-----c
//        \   /
//         \ /
//          d
ConcurrentSplits::Candidate ConcurrentSplits::candidate(EdgeId e) const {
    const TriMesh& mesh = active_.mesh();
    const HalfEdgeId h = mesh.half_edge(e), twin = mesh.twin(h);
    Candidate found{e, mesh.target(h)};
    if (active_.entry_of(e) && mesh.is_smooth(e)) {
        found.corners = CornerClaims::corners(
            active_, {mesh.origin(h), found.end, mesh.origin(TriMesh::prev(h)),
                      mesh.origin(TriMesh::prev(twin))});
    }
    return found;
}

// Accepts edges in the order of the partition. An edge that has to wait for a later one is tried
// again after it.
void ConcurrentSplits::choose(Partition& partition) {
    partition.order.clear();
    std::size_t before = 0;
    do {
        before = partition.order.size();
        for (Candidate& candidate : partition.candidates) {
            if (candidate.accepted || !candidate.corners) continue;
            if (!claims_.are_owned_by(*candidate.corners, partition.number) ||
                !may_split_now(candidate.edge))
                continue;
            candidate.accepted = true;
            chosen_[*active_.entry_of(candidate.edge)] = 1;
            partition.order.push_back(candidate.edge);
        }
    } while (partition.order.size() > before &&
             partition.order.size() < partition.candidates.size());
}

bool ConcurrentSplits::is_chosen(EdgeId e) const {
    const auto entry = active_.entry_of(e);
    return entry && chosen_[*entry] != 0;
}

// Whether no edge of e's faces precedes e once the edges chosen so far have been split.
bool ConcurrentSplits::may_split_now(EdgeId e) {
    if (is_chosen(e)) return false;  // the batch has e twice
    return is_symmetric_ ? both_faces_allow<RestEdge>(e) : both_faces_allow<double>(e);
}

// Edge: RestEdge with symmetry. Without it the length is enough and is much faster.
template <typename Edge>
bool ConcurrentSplits::both_faces_allow(EdgeId e) {
    const Edge own = rest_edge<Edge>(e);
    const HalfEdgeId h = active_.mesh().half_edge(e);
    return face_allows(h, own) && face_allows(active_.mesh().twin(h), own);
}

template <typename Edge>
bool ConcurrentSplits::face_allows(HalfEdgeId h, const Edge& own) {
    const TriMesh& mesh = active_.mesh();
    const EdgeId next = mesh.edge(TriMesh::next(h)), prev = mesh.edge(TriMesh::prev(h));
    const bool is_next_chosen = is_chosen(next), is_prev_chosen = is_chosen(prev);
    if (!is_next_chosen && !is_prev_chosen) {
        return order_.fits_beside(rest_edge<Edge>(next), own) &&
               order_.fits_beside(rest_edge<Edge>(prev), own);
    }
    // Once `split` has been split at m, e's face consists of e, half of `split` from `near` to m,
    // and the edge from `apex` to m. If both neighbours are chosen, either may be split first.
    const auto fits = [&](EdgeId split, VertexId near, VertexId apex) {
        const Vec3 m = rest_midpoint(split);
        const double half = 0.5 * static_cast<double>(active_.cached_rest_length(split)),
                     spoke = static_cast<double>(active_.spoke_rest_length(apex, m));
        return order_.fits_beside(edge_to_midpoint<Edge>(half, near, m), own) &&
               order_.fits_beside(edge_to_midpoint<Edge>(spoke, apex, m), own);
    };
    return (!is_next_chosen || fits(next, mesh.target(h), mesh.origin(h))) &&
           (!is_prev_chosen || fits(prev, mesh.origin(h), mesh.target(h)));
}

template <typename Edge>
Edge ConcurrentSplits::rest_edge(EdgeId e) {
    const auto length = static_cast<double>(active_.cached_rest_length(e));
    if constexpr (std::is_same_v<Edge, RestEdge>) {
        return order_.rest_edge(active_, e, length);
    } else {
        return length;
    }
}

// The edge from v to the midpoint m, which does not exist yet.
template <typename Edge>
Edge ConcurrentSplits::edge_to_midpoint(double length, VertexId v, const Vec3& m) const {
    if constexpr (std::is_same_v<Edge, RestEdge>) {
        return {length, active_.rest_position(v), m};
    } else {
        return length;
    }
}

Vec3 ConcurrentSplits::rest_midpoint(EdgeId e) const {
    const HalfEdgeId h = active_.mesh().half_edge(e);
    return 0.5 * active_.rest_position(active_.mesh().origin(h)) +
           0.5 * active_.rest_position(active_.mesh().target(h));
}

// --- Splitting the chosen edges

// Gives each partition a range of the slots to be reserved and returns their number. Where levels
// or the budget do not allow all splits, all edges are deferred.
std::uint32_t ConcurrentSplits::assign_slots() {
    std::uint32_t count = 0;
    for (Partition& partition : partitions_) {
        partition.first = count;
        count += static_cast<std::uint32_t>(partition.order.size());
    }
    const TriMesh& mesh = active_.mesh();
    if (mesh.has_levels_for(count) && mesh.face_count() + std::size_t{2} * count <= budget_)
        return count;
    for (Partition& partition : partitions_) defer_all(partition);
    return 0;
}

void ConcurrentSplits::defer_all(Partition& partition) {
    release(partition);
    for (Candidate& candidate : partition.candidates) candidate.accepted = false;
    partition.order.clear();
}

void ConcurrentSplits::allocate(std::uint32_t count) {
    embedding_.reserve_splits(count);
    for (Partition& partition : partitions_) {
        partition.inserted.reserve(partition.order.size());
        partition.needed.reserve(EdgeClassifier::kMaxNeeded * partition.order.size());
        partition.scratch.resize(embedding_.scratch_size());
    }
    active_.allocate_splits(count, slots_);
    embedding_.fit_to_entries();
}

void ConcurrentSplits::split_chosen(Partition& partition) {
    partition.inserted.clear();
    for (std::size_t i = 0; i < partition.order.size(); ++i) {
        partition.inserted.push_back(
            active_.concurrent_split(partition.order[i], slots_, partition.first + i));
    }
    embedding_.embed_inserted(partition.inserted, partition.scratch);
    partition.needed.clear();
    for (const ActiveSet::Inserted& made : partition.inserted) {
        classifier_.classify_one_ring(made, [&](EdgeId e, std::uint16_t length_class) {
            partition.needed.emplace_back(e, length_class);
        });
    }
}

// Clears the partition's claims and its marks in chosen_ for the next call.
void ConcurrentSplits::release(Partition& partition) {
    for (const Candidate& candidate : partition.candidates) {
        if (candidate.accepted) chosen_[*active_.entry_of(candidate.edge)] = 0;
        if (candidate.corners) claims_.release(*candidate.corners);
    }
}

}  // namespace pectin

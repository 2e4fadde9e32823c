// Splits many edges on several threads.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "adapt/concurrent/corner_claims.h"
#include "adapt/edge_classifier.h"
#include "adapt/refinement_queue.h"
#include "adapt/split_order.h"
#include "embedding/embedding.h"
#include "mesh/active_set.h"

namespace pectin {

// A batch has edges in several partitions. The edges accepted in different partitions share no
// corner of their faces, so partitions can be split at the same time, and the mesh is the same as
// if they were split one after another. An edge is deferred if
// - one of its corners belongs to another partition,
// - another edge has to be split before it (Propagation),
// - symmetry is on and it is between mirrored ends beside a longer edge,
// - it is a crease or on a boundary or cut, or
// - the edge or one of the four vertices of its faces has no entry in the active set.
// If levels or the budget do not allow all accepted edges, all edges are deferred. All of that
// depends on the partitions alone and not on the number of threads.
class ConcurrentSplits {
  public:
    ConcurrentSplits(ActiveSet& active, Embedding& embedding, const EdgeClassifier& classifier,
                     const AdaptLimits& limits)
        : active_(active),
          embedding_(embedding),
          classifier_(classifier),
          budget_(limits.budget),
          is_symmetric_(limits.symmetry.has_value()),
          order_(limits.propagation, limits.symmetry) {}

    struct Result {
        std::uint64_t splits = 0;
        bool floor_hit = false;  // a new edge needs refinement, but is too short for it
        // Edges left for the caller to split one by one: an element for each partition.
        std::span<const PendingSplits> deferred;
    };
    // Splits the edges of the batch that still need it and embeds the new vertices. Queues the new
    // edges that need refinement. If most edges were accepted, it queues the deferred ones again,
    // behind those they may have to wait for; otherwise it returns them.
    //
    // Throws std::bad_alloc before anything has changed, or while edges are queued. Cost: O(edges)
    // if few have to wait for others of their partition, at worst quadratic in the size of a
    // partition. The result is valid until the next call.
    Result split(const RefinementQueue::Batch& batch, RefinementQueue& queue);

  private:
    struct Candidate {
        EdgeId edge;
        VertexId end = kNone<VertexId>;
        std::optional<CornerClaims::Corners> corners{};  // none if the edge is deferred anyway
        bool accepted = false;
    };
    struct Partition {
        CornerClaims::PartitionIndex number = 0;
        std::span<const EdgeId> edges;
        std::vector<Candidate> candidates;
        std::vector<EdgeId> order;  // accepted edges, in the order of their splits
        std::size_t first = 0;      // the reserved slot of the first of them
        std::vector<ActiveSet::Inserted> inserted;
        std::vector<std::pair<EdgeId, std::uint16_t>>
            needed;                       // edges and length classes, after the splits
        std::vector<DragWeight> scratch;  // for embed_inserted()
    };

    void collect_candidates(Partition& partition, std::size_t length_class);
    Candidate candidate(EdgeId e) const;
    void choose(Partition& partition);
    bool may_split_now(EdgeId e);
    template <typename Edge>
    bool both_faces_allow(EdgeId e);
    template <typename Edge>
    bool face_allows(HalfEdgeId h, const Edge& own);
    template <typename Edge>
    Edge rest_edge(EdgeId e);
    template <typename Edge>
    Edge edge_to_midpoint(double length, VertexId v, const Vec3& m) const;
    Vec3 rest_midpoint(EdgeId e) const;
    bool is_chosen(EdgeId e) const;
    std::uint32_t assign_slots();
    void defer_all(Partition& partition);
    void allocate(std::uint32_t count);
    void split_chosen(Partition& partition);
    void release(Partition& partition);
    bool queue_needed(RefinementQueue& queue) const;
    bool accepted_most() const;
    void defer(RefinementQueue& queue, std::size_t length_class);

    ActiveSet& active_;
    Embedding& embedding_;
    const EdgeClassifier& classifier_;
    std::uint64_t budget_;
    bool is_symmetric_;
    SplitOrder order_;
    std::array<Partition, kPartitions> partitions_;
    CornerClaims claims_;
    std::vector<std::uint8_t> chosen_;  // edge entries: 1 if split in this call
    ActiveSet::ReservedSlots slots_;
    std::array<PendingSplits, kPartitions> deferred_;
};

}  // namespace pectin

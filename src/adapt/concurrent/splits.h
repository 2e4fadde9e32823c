// Splitting many edges on several threads.
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

// Edges come in lanes. What is split in different lanes has no corner of its faces in common, so
// that lanes may go at the same time and the mesh comes out as if they went one after another. Left
// over is an edge of whose corners one belongs to another lane, one that something has to be split
// before, one between mirrored ends beside a longer one, a crease, a boundary, and one at the rim
// of what is active. All of it depends on the lanes alone, not on the threads.
class ConcurrentSplits {
  public:
    ConcurrentSplits(ActiveSet& active, Embedding& embedding, const EdgeClassifier& classifier,
                     const AdaptLimits& limits)
        : active_(active),
          embedding_(embedding),
          classifier_(classifier),
          limits_(limits),
          order_(limits) {}

    // Splits those that still need it and places what this inserts. Throws std::bad_alloc before
    // anything has been changed. Cost: O(edges), if few have to go before others of their lane that
    // come first; else up to the square of a lane.
    void split(const RefinementQueue::Entries& next);

    // How many the last call has split.
    std::size_t split_count() const { return slots_.ids.size(); }
    // visit(lane, edge, octave or why it has none), of the edges that need refinement because of
    // what has been inserted, in order.
    template <typename Visit>
    void for_each_new(Visit visit) const {
        for (const Partition& partition : partitions_) {
            for (const auto& [edge, octave] : partition.made) visit(partition.number, edge, octave);
        }
    }
    // Whether more was split than left over.
    bool accepted_most() const;
    // visit(lane, edge, where it ended before), of what it has left over, in order.
    template <typename Visit>
    void for_each_deferred(Visit visit) const {
        for (const Partition& partition : partitions_) {
            for (const Candidate& deferred : partition.candidates) {
                if (!deferred.accepted) visit(partition.number, deferred.edge, deferred.end);
            }
        }
    }

  private:
    struct Candidate {
        EdgeId edge;
        VertexId end = kNone<VertexId>;
        std::optional<CornerClaims::Corners> corners{};  // none where it is left over in any case
        bool accepted = false;
    };
    struct Partition {
        CornerClaims::PartitionIndex number = 0;
        std::span<const EdgeId> edges;
        std::vector<Candidate> candidates;
        std::vector<EdgeId> order;  // of those that go
        std::size_t first = 0;      // the place of its first
        std::vector<ActiveSet::Inserted> inserted;
        std::vector<std::pair<EdgeId, std::uint16_t>> made;
        std::vector<DragWeight> scratch;  // of embed_inserted()
    };

    void collect_candidates(Partition& partition, std::size_t octave);
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

    ActiveSet& active_;
    Embedding& embedding_;
    const EdgeClassifier& classifier_;
    const AdaptLimits& limits_;
    SplitOrder order_;
    std::array<Partition, kPartitions> partitions_;
    CornerClaims claims_;
    std::vector<std::uint8_t> chosen_;  // edge entries: whether split in this call
    ActiveSet::ReservedSlots slots_;
};

}  // namespace pectin

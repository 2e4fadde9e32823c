// Undoes many splits on several threads.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "adapt/concurrent/corner_claims.h"
#include "adapt/concurrent/partitions.h"
#include "adapt/criteria.h"
#include "mesh/active_set.h"

namespace pectin {

// No two removable vertices of one level are neighbours. So whether one of them may be removed does
// not depend on the others, nor do the faces around it, and the mesh is the same in whatever order
// they are removed.
//
// They are divided into partitions by their base faces, which lie together in memory and mostly in
// space. A partition claims the corners of what it removes. A vertex with a corner that another
// partition has claimed is removed after all partitions are done. Which vertices these are depends
// on the threads, but the order in the log does not. A vertex on a crease, on a boundary or with a
// corner outside the active set is removed last, one by one.
class ConcurrentUnsplits {
  public:
    ConcurrentUnsplits(ActiveSet& active, const Criteria& criteria)
        : active_(active), criteria_(criteria) {}

    // Whether a level has enough vertices for concurrent work.
    bool is_worth(std::span<const VertexId> level) const {
        return criteria_.limits().partitioning.is_worth(level.size());
    }

    // Removes the vertices of one level that may be removed (removable_star()) and returns their
    // number. Throws std::bad_alloc if there is not enough memory: before anything has changed, or
    // between two vertices that are removed one by one. Precondition: the level is not empty. Cost:
    // O(vertices + vertex entries).
    std::uint64_t unsplit(std::span<const VertexId> level);

  private:
    struct Partition {
        CornerClaims::PartitionIndex number = 0;
        std::vector<VertexId> vertices;
        std::vector<ActiveSet::Unsplit> unsplits;
        std::vector<ActiveSet::FormerErrors> errors;  // of the unsplits, if the mesh tracks errors
        ActiveSet::UnsplitCount count;
        ActiveSet::ReservedLogSlots slots;
        std::vector<std::size_t> deferred;  // indices of the unsplits that have yet to be done
        std::vector<VertexId> last;         // to be removed one by one
    };

    void distribute(std::span<const VertexId> level);
    void reserve(Partition& partition) const;
    ActiveSet::Unsplit unsplit(Partition& partition, const Star& star, std::size_t i);
    std::optional<CornerClaims::Corners> corners_of(const Star& star) const;
    void unsplit(Partition& partition);
    void unsplit_deferred(Partition& partition);
    void log();

    ActiveSet& active_;
    const Criteria& criteria_;
    std::array<Partition, kPartitions> partitions_;
    CornerClaims claims_;
};

}  // namespace pectin

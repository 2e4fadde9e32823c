// Undoing many splits on several threads.
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

// Of vertices of one level none that may go is another's neighbour. So whether one may go does not
// depend on whether others have gone, nor do the faces round it, and the mesh comes out the same in
// whatever order they go. They are parted into lanes for the threads, by their base faces, which
// lie together in memory and mostly in space; and a lane owns the corners of what it removes. What
// has a corner of another lane's is removed after these; which they are depends on the threads, but
// where each is logged does not. What lies on a crease, a boundary, or outside the active set goes
// last, one by one.
class ConcurrentUnsplits {
  public:
    ConcurrentUnsplits(ActiveSet& active, const Criteria& criteria)
        : active_(active), criteria_(criteria) {}

    // Removes those of one level that may go; how many these were. Throws std::bad_alloc where
    // there is no memory: before anything has been changed, or between two that go one by one.
    // Precondition: at least one. Cost: O(vertices + vertex entries).
    std::uint64_t unsplit(std::span<const VertexId> level);

  private:
    struct Partition {
        CornerClaims::PartitionIndex number = 0;
        std::vector<VertexId> vertices;
        std::vector<ActiveSet::Unsplit> unsplits;
        ActiveSet::UnsplitCount count;
        ActiveSet::ReservedLogSlots slots;
        std::vector<std::size_t> deferred;  // which of these have yet to be done
        std::vector<VertexId> last;
    };

    void distribute(std::span<const VertexId> level);
    static void reserve(Partition& partition);
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

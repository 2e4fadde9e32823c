#include "adapt/concurrent/unsplits.h"

#include <algorithm>
#include <utility>

#include "adapt/decimate.h"
#include "geometry/parallel.h"

namespace pectin {
namespace {

// Vertices that the borders between partitions are estimated from.
constexpr std::size_t kSample = 1024;

}  // namespace

std::uint64_t ConcurrentUnsplits::unsplit(std::span<const VertexId> level) {
    claims_.begin(active_.vertex_entries());
    distribute(level);
    for (Partition& partition : partitions_) reserve(partition);
    active_.reserve_unsplits(level.size());
    for_each_concurrently(partitions_, [this](Partition& partition) { unsplit(partition); });
    std::uint64_t removed = 0;
    for (Partition& partition : partitions_) {
        unsplit_deferred(partition);
        removed += partition.unsplits.size();
    }
    log();
    for (const Partition& partition : partitions_) {
        for (VertexId m : partition.last) active_.unsplit(*active_.mesh().removable(m));
        removed += partition.last.size();
    }
    return removed;
}

// Writes all partitions to the log, in their order.
void ConcurrentUnsplits::log() {
    for_each_concurrently(partitions_, [this](Partition& partition) {
        partition.count = active_.count(partition.unsplits);
    });
    for (Partition& partition : partitions_)
        partition.slots = active_.allocate_unsplits(partition.count);
    for_each_concurrently(partitions_, [this](Partition& partition) {
        active_.log_unsplits(partition.unsplits, partition.errors, partition.slots);
    });
}

// Sorts the vertices into partitions of about equal size by their base faces. Those of one base
// face keep their order.
void ConcurrentUnsplits::distribute(std::span<const VertexId> level) {
    using SortKey = std::pair<FaceId, std::size_t>;
    const auto sort_key = [&, mesh = &active_.mesh()](std::size_t i) {
        return SortKey(mesh->base_face(TriMesh::face(mesh->half_edge(level[i]))), i);
    };
    std::vector<SortKey> sample;
    for (std::size_t i = 0; i < level.size(); i += 1 + level.size() / kSample) {
        sample.push_back(sort_key(i));
    }
    std::ranges::sort(sample);
    const std::size_t count = criteria_.limits().partitioning.count;
    std::vector<SortKey> borders;
    for (std::size_t i = 1; i < count; ++i) borders.push_back(sample[i * sample.size() / count]);
    for (std::size_t i = 0; i < kPartitions; ++i) {
        partitions_[i].number = static_cast<CornerClaims::PartitionIndex>(i);
        partitions_[i].vertices.clear();
    }
    for (std::size_t i = 0; i < level.size(); ++i) {
        const auto partition = std::ranges::upper_bound(borders, sort_key(i)) - borders.begin();
        partitions_[static_cast<std::size_t>(partition)].vertices.push_back(level[i]);
    }
}

// Allocates what unsplit() may need, so that it does not throw.
void ConcurrentUnsplits::reserve(Partition& partition) const {
    partition.unsplits.clear();
    partition.deferred.clear();
    partition.last.clear();
    partition.unsplits.reserve(partition.vertices.size());
    partition.deferred.reserve(partition.vertices.size());
    partition.last.reserve(partition.vertices.size());
    if (active_.mesh().tracks_errors()) partition.errors.resize(partition.vertices.size());
}

// The removal that is number i of the partition.
ActiveSet::Unsplit ConcurrentUnsplits::unsplit(Partition& partition, const Star& star,
                                               std::size_t i) {
    return active_.concurrent_unsplit(star,
                                      partition.errors.empty() ? nullptr : &partition.errors[i]);
}

// Until it has claimed the corners of a star, a partition only reads what no other partition
// writes.
void ConcurrentUnsplits::unsplit(Partition& partition) {
    for (VertexId m : partition.vertices) {
        const auto star = removable_star(active_, criteria_, m);
        if (!star) continue;
        const auto corners = corners_of(*star);
        if (!corners) {
            partition.last.push_back(m);
        } else if (claims_.try_claim(*corners, partition.number)) {
            partition.unsplits.push_back(unsplit(partition, *star, partition.unsplits.size()));
        } else {
            partition.deferred.push_back(partition.unsplits.size());
            partition.unsplits.push_back({.ids = {.m = m}});
        }
    }
}

// None if the vertex has to be removed by itself.
std::optional<CornerClaims::Corners> ConcurrentUnsplits::corners_of(const Star& star) const {
    if (!active_.may_unsplit_concurrently(star)) return std::nullopt;
    return CornerClaims::corners(active_, {star.a, star.b, star.c, star.d});
}

void ConcurrentUnsplits::unsplit_deferred(Partition& partition) {
    for (std::size_t i : partition.deferred) {
        ActiveSet::Unsplit& deferred = partition.unsplits[i];
        deferred = unsplit(partition, *active_.mesh().removable(deferred.ids.m), i);
    }
}

}  // namespace pectin

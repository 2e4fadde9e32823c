// Edges waiting to be split, longest first by octave of squared length.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "adapt/concurrent/partitions.h"
#include "mesh/ids.h"

namespace pectin {

// Within an octave edges wait in lanes, first come, first served in each. Where many wait, all
// lanes are served at once, so that each may have a thread. An edge goes to the lane of what it
// came of, and a lane that has run out takes over half of the longest, so each has a part of the
// surface to itself and that part stays in a thread's cache. push: O(1). take: O(1), but for
// octaves passed and edges taken over. The queue alone is several times as fast as a binary heap by
// length (tests/bench/queue_bench.cpp).
class RefinementQueue {
  public:
    static constexpr std::size_t kOctaves = 2048;      // the exponents of a double
    static constexpr std::size_t kSerialBatch = 1024;  // taken at a time, where one lane is served

    struct Entries {
        std::array<std::span<const EdgeId>, kPartitions> partitions;
        std::size_t octave = 0;
        bool is_one_partition = false;
    };

    // partition_batch: taken from each lane at a time, where all are served.
    explicit RefinementQueue(std::size_t partition_batch = kPartitionBatch)
        : partition_batch_(partition_batch) {}

    void push(EdgeId e, std::size_t octave, std::size_t partition = 0) {
        if (buckets_.empty()) lowest_ = octave;
        if (octave < lowest_) {
            buckets_.insert(buckets_.begin(), lowest_ - octave, {});
            longest_ += lowest_ - octave;
            lowest_ = octave;
        }
        const std::size_t bucket = octave - lowest_;
        if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
        buckets_[bucket].push(e, partition);
        longest_ = std::max(longest_, bucket);
    }

    // Whether none waits. Goes on to the longest octave that has some.
    bool is_empty() {
        if (buckets_.empty()) return true;
        while (buckets_[longest_].is_empty() && longest_ > 0) --longest_;
        return buckets_[longest_].is_empty();
    }

    // Some of the longest octave. Valid until the next push. Precondition: not is_empty().
    Entries take() {
        Entries entries = buckets_[longest_].take(partition_batch_);
        entries.octave = lowest_ + longest_;
        return entries;
    }

    static std::size_t octave_of(double squared_length) {
        return (std::bit_cast<std::uint64_t>(squared_length) >> 52) & (kOctaves - 1);
    }

  private:
    struct Partition {
        std::vector<EdgeId> edges;
        std::size_t taken = 0;

        std::size_t waiting() const { return edges.size() - taken; }
        void push(EdgeId e) {
            if (taken == edges.size()) {
                edges.clear();
                taken = 0;
            }
            edges.push_back(e);
        }
        std::span<const EdgeId> take(std::size_t most) {
            const std::size_t first = taken;
            taken = std::min(edges.size(), first + most);
            return std::span(edges).subspan(first, taken - first);
        }
        void give_half(Partition& empty) {
            const auto half = edges.end() - static_cast<std::ptrdiff_t>(waiting() / 2);
            empty.edges.assign(half, edges.end());
            empty.taken = 0;
            edges.erase(half, edges.end());
        }
    };

    class Bucket {
      public:
        bool is_empty() const { return waiting_ == 0; }
        void push(EdgeId e, std::size_t partition) {
            partitions_[partition].push(e);
            ++waiting_;
        }
        Entries take(std::size_t partition_batch) {
            Entries entries;
            entries.is_one_partition = !are_worth_partitioning(waiting_, partition_batch);
            if (!entries.is_one_partition) fill_empty_partitions(partition_batch);
            for (std::size_t i = 0; i < kPartitions; ++i) {
                if (partitions_[i].waiting() == 0) continue;
                entries.partitions[i] =
                    partitions_[i].take(entries.is_one_partition ? kSerialBatch : partition_batch);
                waiting_ -= entries.partitions[i].size();
                if (entries.is_one_partition) break;
            }
            return entries;
        }

      private:
        void fill_empty_partitions(std::size_t partition_batch) {
            for (Partition& partition : partitions_) {
                if (partition.waiting() > 0) continue;
                Partition& longest =
                    *std::ranges::max_element(partitions_, {}, &Partition::waiting);
                if (longest.waiting() > 2 * partition_batch) longest.give_half(partition);
            }
        }
        std::array<Partition, kPartitions> partitions_;
        std::size_t waiting_ = 0;  // in all of them
    };

    std::size_t partition_batch_;
    std::vector<Bucket> buckets_;  // of the octaves from lowest_ on
    std::size_t lowest_ = 0;
    std::size_t longest_ = 0;  // the last bucket that is not empty, or beyond
};

}  // namespace pectin

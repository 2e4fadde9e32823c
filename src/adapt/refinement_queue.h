// The edges that wait for a split, longest first.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, the refinement heap, and point 3.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "adapt/concurrent/partitions.h"
#include "mesh/ids.h"

namespace pectin {

// An edge that is to be split, and its end when that was decided. If the edge ends elsewhere when
// its turn comes, it has been split in the meantime and its id stands for one of its halves.
struct PendingSplit {
    EdgeId edge;
    VertexId end;
};

// Edges to be split one by one, in this order. The edges that their splits produce are queued in
// `partition` (see RefinementQueue).
struct PendingSplits {
    std::vector<PendingSplit> splits;
    std::size_t partition = 0;
};

// Takes the place of the paper's heap by decreasing edge length: a bucket queue, ordered by length
// class, longest first, and FIFO within a class. A length class holds the edges whose squared
// lengths have the same binary exponent, so lengths in it differ by a factor of less than sqrt(2).
// The queue is several times as fast as a binary heap (tests/bench/queue_bench.cpp).
//
// Each length class is divided into partitions, so that threads can drain them independently. New
// edges join the partition of the edge that produced them; an empty partition takes over half of
// the longest one. This keeps each partition's part of the surface in one thread's cache. push
// costs O(1); take costs O(1) apart from classes passed over and edges taken over.
class RefinementQueue {
  public:
    static constexpr std::size_t kLengthClasses = 2048;  // the exponents of a double
    static constexpr std::size_t kSerialBatch = 1024;

    // Edges of one length class, taken together. A serial batch has edges of one partition.
    struct Batch {
        std::array<std::span<const EdgeId>, kPartitions> partitions;
        std::size_t length_class = 0;
        bool is_serial = false;
        std::size_t partition = 0;  // of a serial batch

        std::span<const EdgeId> serial_edges() const { return partitions[partition]; }
    };

    // serial_batch: edges in a serial batch, at most; kWholeClass for all of a length class.
    static constexpr std::size_t kWholeClass = std::numeric_limits<std::size_t>::max();
    explicit RefinementQueue(const Partitioning& partitioning = {},
                             std::size_t serial_batch = kSerialBatch)
        : partitioning_(partitioning), serial_batch_(serial_batch) {}

    void push(EdgeId e, std::size_t length_class, std::size_t partition = 0) {
        if (buckets_.empty()) lowest_ = length_class;
        if (length_class < lowest_) {
            buckets_.insert(buckets_.begin(), lowest_ - length_class, {});
            longest_ += lowest_ - length_class;
            lowest_ = length_class;
        }
        const std::size_t bucket = length_class - lowest_;
        if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
        buckets_[bucket].push(e, partition);
        longest_ = std::max(longest_, bucket);
    }

    // Also advances to the longest length class in which edges wait.
    bool is_empty() {
        if (buckets_.empty()) return true;
        while (buckets_[longest_].is_empty() && longest_ > 0) --longest_;
        return buckets_[longest_].is_empty();
    }

    // Removes edges of the longest length class. The batch is valid until the next push.
    // Precondition: is_empty() has just returned false.
    Batch take() {
        Batch batch = buckets_[longest_].take(partitioning_, serial_batch_);
        batch.length_class = lowest_ + longest_;
        return batch;
    }

    static std::size_t length_class_of(double squared_length) {
        return (std::bit_cast<std::uint64_t>(squared_length) >> 52) & (kLengthClasses - 1);
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
            taken = first + std::min(waiting(), most);
            return std::span(edges).subspan(first, taken - first);
        }
        void give_half(Partition& empty) {
            const auto half = edges.end() - static_cast<std::ptrdiff_t>(waiting() / 2);
            empty.edges.assign(half, edges.end());
            empty.taken = 0;
            edges.erase(half, edges.end());
        }
    };

    // One length class.
    class Bucket {
      public:
        bool is_empty() const { return waiting_ == 0; }
        void push(EdgeId e, std::size_t partition) {
            partitions_[partition].push(e);
            ++waiting_;
        }
        Batch take(const Partitioning& partitioning, std::size_t serial_batch) {
            return partitioning.is_worth(waiting_) ? take_from_all(partitioning)
                                                   : take_from_one(serial_batch);
        }

      private:
        Batch take_from_one(std::size_t most) {
            Batch batch;
            batch.is_serial = true;
            while (partitions_[batch.partition].waiting() == 0) ++batch.partition;
            take_some(batch, batch.partition, most);
            return batch;
        }
        Batch take_from_all(const Partitioning& partitioning) {
            fill_empty_partitions(partitioning);
            Batch batch;
            for (std::size_t i = 0; i < kPartitions; ++i) take_some(batch, i, partitioning.batch);
            return batch;
        }
        void take_some(Batch& batch, std::size_t partition, std::size_t most) {
            batch.partitions[partition] = partitions_[partition].take(most);
            waiting_ -= batch.partitions[partition].size();
        }
        void fill_empty_partitions(const Partitioning& partitioning) {
            for (std::size_t i = 0; i < partitioning.count; ++i) {
                if (partitions_[i].waiting() > 0) continue;
                Partition& longest =
                    *std::ranges::max_element(partitions_, {}, &Partition::waiting);
                if (longest.waiting() > 2 * partitioning.batch) longest.give_half(partitions_[i]);
            }
        }
        std::array<Partition, kPartitions> partitions_;
        std::size_t waiting_ = 0;  // in all partitions
    };

    Partitioning partitioning_;
    std::size_t serial_batch_;
    std::vector<Bucket> buckets_;  // one for each length class from lowest_ on
    std::size_t lowest_ = 0;
    std::size_t longest_ = 0;  // no bucket after this one has edges
};

}  // namespace pectin

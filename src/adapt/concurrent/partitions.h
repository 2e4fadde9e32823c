// How many edits are divided among threads.
#pragma once

#include <cstddef>
#include <limits>

namespace pectin {

// Partitions a pass may have at most. More of them make later edits slower, since elements that are
// close in space are then less close in memory.
inline constexpr std::size_t kPartitions = 4;

// Edits that a partition makes at a time.
inline constexpr std::size_t kPartitionBatch = 512;

// When edits are made concurrently, and in how many partitions. The order of edits depends on this,
// but never on the number of threads.
struct Partitioning {
    static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

    std::size_t count = kPartitions;      // 1 to kPartitions
    std::size_t batch = kPartitionBatch;  // edits of a partition at a time; kNever: all are serial

    // Whether this many waiting edits are worth concurrent work.
    bool is_worth(std::size_t waiting) const { return waiting / (2 * count) >= batch; }
};

}  // namespace pectin

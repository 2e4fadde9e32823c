// Lanes of edits, each of which may have a thread.
#pragma once

#include <cstddef>

namespace pectin {

// More make later edits slower, since what lies together in space does so less in memory then.
inline constexpr std::size_t kPartitions = 4;

// Edits that a lane does at a time.
inline constexpr std::size_t kPartitionBatch = 512;

// Whether so many edits that wait are worth several threads.
constexpr bool are_worth_partitioning(std::size_t waiting, std::size_t partition_batch) {
    return waiting >= 2 * kPartitions * partition_batch;
}

}  // namespace pectin

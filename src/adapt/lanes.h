// Lanes of edits, each of which may have a thread.
#pragma once

#include <cstddef>

namespace pectin {

// More make later edits slower, since what lies together in space does so less in memory then.
inline constexpr std::size_t kLanes = 4;

// Edits that a lane does at a time.
inline constexpr std::size_t kLaneLength = 512;

// Whether so many edits that wait are worth several threads.
constexpr bool are_worth_lanes(std::size_t waiting, std::size_t lane_length) {
    return waiting >= 2 * kLanes * lane_length;
}

}  // namespace pectin

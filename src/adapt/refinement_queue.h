// Edges waiting to be split, longest first by octave of squared length.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "adapt/lanes.h"
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
    static constexpr std::size_t kOctaves = 2048;    // the exponents of a double
    static constexpr std::size_t kInOneLane = 1024;  // taken at a time, where one lane is served

    struct Entries {
        std::array<std::span<const EdgeId>, kLanes> lanes;
        std::size_t octave = 0;
        bool is_one_lane = false;
    };

    // lane_length: taken from each lane at a time, where all are served.
    explicit RefinementQueue(std::size_t lane_length = kLaneLength) : lane_length_(lane_length) {}

    void push(EdgeId e, std::size_t octave, std::size_t lane = 0) {
        if (buckets_.empty()) lowest_ = octave;
        if (octave < lowest_) {
            buckets_.insert(buckets_.begin(), lowest_ - octave, {});
            longest_ += lowest_ - octave;
            lowest_ = octave;
        }
        const std::size_t bucket = octave - lowest_;
        if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
        buckets_[bucket].push(e, lane);
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
        Entries entries = buckets_[longest_].take(lane_length_);
        entries.octave = lowest_ + longest_;
        return entries;
    }

    static std::size_t octave_of(double squared_length) {
        return (std::bit_cast<std::uint64_t>(squared_length) >> 52) & (kOctaves - 1);
    }

  private:
    struct Lane {
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
        void give_half(Lane& empty) {
            const auto half = edges.end() - static_cast<std::ptrdiff_t>(waiting() / 2);
            empty.edges.assign(half, edges.end());
            empty.taken = 0;
            edges.erase(half, edges.end());
        }
    };

    class Bucket {
      public:
        bool is_empty() const { return waiting_ == 0; }
        void push(EdgeId e, std::size_t lane) {
            lanes_[lane].push(e);
            ++waiting_;
        }
        Entries take(std::size_t lane_length) {
            Entries entries;
            entries.is_one_lane = !are_worth_lanes(waiting_, lane_length);
            if (!entries.is_one_lane) fill_empty_lanes(lane_length);
            for (std::size_t i = 0; i < kLanes; ++i) {
                if (lanes_[i].waiting() == 0) continue;
                entries.lanes[i] = lanes_[i].take(entries.is_one_lane ? kInOneLane : lane_length);
                waiting_ -= entries.lanes[i].size();
                if (entries.is_one_lane) break;
            }
            return entries;
        }

      private:
        void fill_empty_lanes(std::size_t lane_length) {
            for (Lane& lane : lanes_) {
                if (lane.waiting() > 0) continue;
                Lane& longest = *std::ranges::max_element(lanes_, {}, &Lane::waiting);
                if (longest.waiting() > 2 * lane_length) longest.give_half(lane);
            }
        }
        std::array<Lane, kLanes> lanes_;
        std::size_t waiting_ = 0;  // in all of them
    };

    std::size_t lane_length_;
    std::vector<Bucket> buckets_;  // of the octaves from lowest_ on
    std::size_t lowest_ = 0;
    std::size_t longest_ = 0;  // the last bucket that is not empty, or beyond
};

}  // namespace pectin

// Edges waiting to be split, longest first by octave of squared length.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/ids.h"

namespace pectin {

// First come, first served within an octave. push: O(1). take: O(1), but for empty octaves passed.
class RefinementQueue {
  public:
    static constexpr std::size_t kOctaves = 2048;  // the exponents of a double

    struct Entries {
        std::span<const EdgeId> edges;
        std::size_t octave = 0;
    };

    void push(EdgeId e, std::size_t octave) {
        if (buckets_.empty()) lowest_ = octave;
        if (octave < lowest_) {
            buckets_.insert(buckets_.begin(), lowest_ - octave, {});
            longest_ += lowest_ - octave;
            lowest_ = octave;
        }
        const std::size_t bucket = octave - lowest_;
        if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
        buckets_[bucket].edges.push_back(e);
        longest_ = std::max(longest_, bucket);
    }

    // The first in the longest octave, no more than `most`; none if none waits. Valid until the
    // next push.
    Entries take(std::size_t most) {
        if (buckets_.empty()) return {};
        while (buckets_[longest_].is_empty()) {
            buckets_[longest_].clear();
            if (longest_ == 0) return {};
            --longest_;
        }
        return Entries{buckets_[longest_].take(most), lowest_ + longest_};
    }

    static std::size_t octave_of(double squared_length) {
        return (std::bit_cast<std::uint64_t>(squared_length) >> 52) & (kOctaves - 1);
    }

  private:
    struct Bucket {
        std::vector<EdgeId> edges;
        std::size_t taken = 0;

        bool is_empty() const { return taken == edges.size(); }
        std::span<const EdgeId> take(std::size_t most) {
            const std::size_t first = taken;
            taken = std::min(edges.size(), first + most);
            return std::span(edges).subspan(first, taken - first);
        }
        void clear() {
            edges.clear();
            taken = 0;
        }
    };
    std::vector<Bucket> buckets_;  // of the octaves from lowest_ on
    std::size_t lowest_ = 0;
    std::size_t longest_ = 0;  // the last bucket that is not empty, or beyond
};

}  // namespace pectin

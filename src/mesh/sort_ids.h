// Radix sort of ids. Sorting ten thousand random ids by comparison costs several times as much,
// since the processor predicts half of the comparisons wrongly.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mesh/ids.h"

namespace pectin {

// Cost: O(n) time and memory; two passes for ids below 2^22.
template <typename Id>
void sort_ids(std::span<Id> ids) {
    constexpr std::size_t kFew = 512;  // below this, std::sort is faster
    constexpr std::uint32_t kDigitBits = 11, kDigits = 1u << kDigitBits;
    if (std::is_sorted(ids.begin(), ids.end())) return;
    if (ids.size() < kFew) {
        std::sort(ids.begin(), ids.end());
        return;
    }
    const std::uint32_t greatest = index(*std::max_element(ids.begin(), ids.end()));
    std::vector<Id> other(ids.size());
    std::span<Id> from = ids, to = other;
    for (std::uint32_t shift = 0; shift < 32 && greatest >> shift != 0; shift += kDigitBits) {
        const auto digit = [&](Id id) { return index(id) >> shift & (kDigits - 1); };
        std::array<std::uint32_t, kDigits> offsets{};
        for (const Id id : from) ++offsets[digit(id)];
        std::uint32_t begin = 0;
        for (std::uint32_t& p : offsets) begin += std::exchange(p, begin);
        for (const Id id : from) to[offsets[digit(id)]++] = id;
        std::swap(from, to);
    }
    if (from.data() != ids.data()) std::copy(from.begin(), from.end(), ids.begin());
}

}  // namespace pectin

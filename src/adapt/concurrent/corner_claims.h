// Which of several lanes of edits may touch a vertex of an active set.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/active_set.h"

namespace pectin {

// A split or unsplit changes its faces and what names them: all of that has its four corners in
// common with it. So lanes that have no corner in common may edit the mesh at the same time.
class CornerClaims {
  public:
    using PartitionIndex = std::uint8_t;
    using Corners = std::array<std::uint32_t, 4>;  // vertex entries of an active set

    // None if one of them has no entry.
    static std::optional<Corners> corners(const ActiveSet& active,
                                          const std::array<VertexId, 4>& vertices) {
        Corners found{};
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto entry = active.entry_of(vertices[i]);
            if (!entry) return std::nullopt;
            found[i] = *entry;
        }
        return found;
    }

    // For so many entries, none of which is anybody's then. O(entries).
    void begin(std::size_t entries) { owners_.assign(entries, kUnowned); }
    std::size_t entries() const { return owners_.size(); }

    // --- Several threads may do the same of these at a time. O(1). Either claim, then
    // are_owned_by: the lowest lane that has claimed a corner has it, whichever thread came first.
    void claim(const Corners& corners, PartitionIndex partition) {
        const PartitionIndex own = mark_of(partition);
        for (std::uint32_t corner : corners) {
            const std::atomic_ref owner(owners_[corner]);
            PartitionIndex known = owner.load(std::memory_order_relaxed);
            while ((known == kUnowned || own < known) &&
                   !owner.compare_exchange_weak(known, own, std::memory_order_relaxed)) {
            }
        }
    }
    bool are_owned_by(const Corners& corners, PartitionIndex partition) const {
        return std::ranges::all_of(
            corners, [&](std::uint32_t corner) { return owners_[corner] == mark_of(partition); });
    }
    // Or the first to come has it. Whether all are the lane's; if not, some may have become so.
    bool try_claim(const Corners& corners, PartitionIndex partition) {
        const PartitionIndex own = mark_of(partition);
        return std::ranges::all_of(corners, [&](std::uint32_t corner) {
            const std::atomic_ref owner(owners_[corner]);
            PartitionIndex known = owner.load(std::memory_order_relaxed);
            return known == own ||
                   (known == kUnowned &&
                    owner.compare_exchange_strong(known, own, std::memory_order_relaxed));
        });
    }
    void release(const Corners& corners) {
        for (std::uint32_t corner : corners) {
            std::atomic_ref(owners_[corner]).store(kUnowned, std::memory_order_relaxed);
        }
    }

  private:
    static constexpr PartitionIndex kUnowned = 0;
    static PartitionIndex mark_of(PartitionIndex partition) {
        return static_cast<PartitionIndex>(partition + 1);
    }

    std::vector<PartitionIndex> owners_;  // of the entries
};

}  // namespace pectin

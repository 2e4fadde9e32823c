// Which partition of concurrent edits may change the surroundings of a vertex.
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

//          a
//         /|\        A split of bc, or the unsplit of m, changes these faces and what refers
//        / | \       to them. All of that has one of the corners a, b, c and d. So partitions
//       b--m--c      whose edits have no corner in common may edit the mesh at the same time.
//        \ | /       Corners are claimed before the edits.
//         \|/
//          d
class CornerClaims {
  public:
    using PartitionIndex = std::uint8_t;
    using Corners = std::array<std::uint32_t, 4>;  // vertex entries of an active set

    // The entries of four corners; none if one of them is not in the active set.
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

    // Prepares for this many entries; nobody owns any of them. Cost: O(entries).
    void begin(std::size_t entries) { owners_.assign(entries, kUnowned); }
    std::size_t entries() const { return owners_.size(); }

    // --- In each of two protocols, several threads may make the same call at the same time.
    // Cost: O(1).

    // First protocol: all claim(), then all ask are_owned_by(). A corner belongs to the partition
    // with the lowest index that claimed it, whichever thread came first.
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
    // Second protocol: a corner belongs to the partition that comes first. Returns whether all
    // corners belong to this partition; if not, it may own some of them all the same.
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

    std::vector<PartitionIndex> owners_;  // for each entry: partition index + 1, or kUnowned
};

}  // namespace pectin

// Which of several lanes of edits may touch a vertex.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

#include "mesh/ids.h"

namespace pectin {

// A split or unsplit changes its faces and what names them: all of that has its four corners in
// common with it. So lanes that have no corner in common may edit the mesh at the same time.
class CornerClaims {
  public:
    using Lane = std::uint8_t;
    using Corners = std::array<VertexId, 4>;

    // For vertices below `slots`, none of which is anybody's. Only what is claimed takes memory.
    void begin(std::size_t slots) {
        lanes_.reset(static_cast<Lane*>(std::calloc(std::max<std::size_t>(slots, 1), 1)));
        if (!lanes_) throw std::bad_alloc();
        slots_ = slots;
    }
    std::size_t slots() const { return slots_; }

    // --- Several threads may do one of these at a time. O(1).
    // In the end a corner is the lowest lane's that has claimed it, whichever thread comes first.
    void claim(const Corners& corners, Lane lane) {
        const Lane own = mark_of(lane);
        for (VertexId corner : corners) {
            const std::atomic_ref owner(lanes_.get()[index(corner)]);
            Lane known = owner.load(std::memory_order_relaxed);
            while ((known == kNobodys || own < known) &&
                   !owner.compare_exchange_weak(known, own, std::memory_order_relaxed)) {
            }
        }
    }
    // The first to come has it. Whether all are the lane's; if not, some may have become so.
    bool take(const Corners& corners, Lane lane) {
        const Lane own = mark_of(lane);
        return std::ranges::all_of(corners, [&](VertexId corner) {
            const std::atomic_ref owner(lanes_.get()[index(corner)]);
            Lane known = owner.load(std::memory_order_relaxed);
            return known == own ||
                   (known == kNobodys &&
                    owner.compare_exchange_strong(known, own, std::memory_order_relaxed));
        });
    }
    bool are_of(const Corners& corners, Lane lane) const {
        return std::ranges::all_of(
            corners, [&](VertexId corner) { return lanes_.get()[index(corner)] == mark_of(lane); });
    }
    void give_up(const Corners& corners) {
        for (VertexId corner : corners) {
            std::atomic_ref(lanes_.get()[index(corner)]).store(kNobodys, std::memory_order_relaxed);
        }
    }

  private:
    static constexpr Lane kNobodys = 0;
    static Lane mark_of(Lane lane) { return static_cast<Lane>(lane + 1); }

    struct Free {
        void operator()(Lane* lanes) const { std::free(lanes); }
    };
    std::unique_ptr<Lane, Free> lanes_;
    std::size_t slots_ = 0;
};

}  // namespace pectin

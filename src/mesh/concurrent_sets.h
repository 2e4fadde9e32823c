// Disjoint sets of indices that several threads join at the same time.
// Source: R. J. Anderson, H. Woll. Wait-free parallel algorithms for the union-find problem.
// Proceedings of the 23rd ACM Symposium on Theory of Computing (1991).
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace pectin {

// The lowest index of a set represents it, so the result does not depend on the order of the joins.
// All functions may run concurrently, except that make(i) has to come before other calls with i.
class ConcurrentSets {
  public:
    ConcurrentSets() = default;
    // Only indices that make() has been called for may be used, and only their memory is touched.
    explicit ConcurrentSets(std::size_t indices)
        : parent_(std::make_unique_for_overwrite<std::uint32_t[]>(indices)) {}

    // Makes a set of i alone. May be called several times before i is joined.
    void make(std::uint32_t i) { at(i).store(i, std::memory_order_relaxed); }

    // The path is halved on the way: whatever another thread has written meanwhile, the value
    // written here is an ancestor too.
    std::uint32_t find(std::uint32_t i) {
        for (;;) {
            const std::uint32_t parent = at(i).load(std::memory_order_relaxed);
            if (parent == i) return i;
            const std::uint32_t above = at(parent).load(std::memory_order_relaxed);
            if (above == parent) return parent;
            at(i).store(above, std::memory_order_relaxed);
            i = above;
        }
    }

    void join(std::uint32_t i, std::uint32_t j) {
        for (;;) {
            i = find(i);
            j = find(j);
            if (i == j) return;
            if (i < j) std::swap(i, j);
            std::uint32_t expected = i;  // still the representative of its set?
            if (at(i).compare_exchange_strong(expected, j, std::memory_order_relaxed)) return;
        }
    }

  private:
    std::atomic_ref<std::uint32_t> at(std::uint32_t i) { return std::atomic_ref(parent_[i]); }

    std::unique_ptr<std::uint32_t[]> parent_;
};

}  // namespace pectin

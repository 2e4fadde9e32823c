// Disjoint sets of indices.
// Source: R. E. Tarjan, J. van Leeuwen. Worst-case analysis of set union algorithms. Journal of the
// ACM 31 (1984).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace pectin {

// Uses path halving (Tarjan & van Leeuwen 1984). The lowest index of a set represents it.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        i = find(i);
        j = find(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

  private:
    std::vector<std::size_t> parent_;
};

}  // namespace pectin

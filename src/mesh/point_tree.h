// A spatial index of plane points for the query whether any of them lies in a triangle.
// Source: J. L. Bentley. Multidimensional binary search trees used for associative searching.
// Communications of the ACM 18 (1975).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace pectin {

// A k-d tree (Bentley 1975) whose points can be removed one by one. Nodes are numbered as in a
// binary heap.
class PointTree {
  public:
    // Contains the points with these indices. Cost: O(n log n).
    PointTree(std::span<const Vec2> points, std::vector<std::uint32_t> members)
        : points_(points), members_(std::move(members)), is_removed_(points.size(), false) {
        std::size_t leaves = 1;
        while (leaves * kLeafSize < members_.size()) leaves *= 2;
        nodes_.resize(2 * leaves);
        leaf_of_.resize(points.size());
        build(1, 0, members_.size());
    }

    bool is_empty() const { return nodes_[1].count == 0; }
    // Cost: O(log n).
    void remove(std::uint32_t point) {
        is_removed_[point] = true;
        for (std::size_t node = leaf_of_[point]; node > 0; node /= 2) --nodes_[node].count;
    }

    // Whether holds(i) is true for any point i that may lie in the counter-clockwise triangle a, b,
    // c. Skips nodes beyond one of its sides or outside its box. Adds the number of visited nodes
    // to `steps`.
    template <typename Holds>
    bool any_near(const std::array<Vec2, 3>& triangle, std::size_t& steps, Holds holds) const {
        return any_near(1, triangle, steps, holds);
    }

  private:
    static constexpr std::size_t kLeafSize = 8;
    struct Node {
        Vec2 min{INFINITY}, max{-INFINITY};
        std::uint32_t count = 0;           // points that are not removed
        std::uint32_t begin = 0, end = 0;  // of members_
    };

    void build(std::size_t n, std::size_t begin, std::size_t end) {
        Node& node = nodes_[n];
        node.begin = static_cast<std::uint32_t>(begin);
        node.end = static_cast<std::uint32_t>(end);
        node.count = node.end - node.begin;
        for (std::size_t i = begin; i < end; ++i) {
            node.min = glm::min(node.min, points_[members_[i]]);
            node.max = glm::max(node.max, points_[members_[i]]);
            leaf_of_[members_[i]] = static_cast<std::uint32_t>(n);
        }
        if (2 * n >= nodes_.size()) return;
        const int axis = node.max.x - node.min.x >= node.max.y - node.min.y ? 0 : 1;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) {
            return members_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t i, std::uint32_t j) {
            return points_[i][axis] < points_[j][axis];
        });
        build(2 * n, begin, middle);
        build(2 * n + 1, middle, end);
    }

    // Whether the node's box lies entirely to the right of the line from p to q, despite rounding.
    static bool is_right_of(const Node& node, const Vec2& p, const Vec2& q) {
        const Vec2 along = q - p;
        const Vec2 leftmost{along.y > 0.0 ? node.min.x : node.max.x,
                            along.x > 0.0 ? node.max.y : node.min.y};
        const double left = along.x * (leftmost.y - p.y), right = along.y * (leftmost.x - p.x);
        constexpr double kRounding = 1e-14;
        return left - right < -kRounding * (std::abs(left) + std::abs(right));
    }

    template <typename Holds>
    bool any_near(std::size_t n, const std::array<Vec2, 3>& t, std::size_t& steps,
                  Holds holds) const {
        ++steps;
        const Node& node = nodes_[n];
        if (node.count == 0) return false;
        const Vec2 low = glm::min(t[0], glm::min(t[1], t[2]));
        const Vec2 high = glm::max(t[0], glm::max(t[1], t[2]));
        if (node.min.x > high.x || node.max.x < low.x || node.min.y > high.y ||
            node.max.y < low.y) {
            return false;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            if (is_right_of(node, t[i], t[(i + 1) % 3])) return false;
        }
        if (2 * n < nodes_.size()) {
            return any_near(2 * n, t, steps, holds) || any_near(2 * n + 1, t, steps, holds);
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            if (!is_removed_[members_[i]] && holds(members_[i])) return true;
        }
        return false;
    }

    std::span<const Vec2> points_;
    std::vector<std::uint32_t> members_;  // those of a node are adjacent
    std::vector<bool> is_removed_;        // n_points
    std::vector<Node> nodes_;             // numbered from 1; node n has the children 2n and 2n + 1
    std::vector<std::uint32_t> leaf_of_;  // n_points; the leaf that holds it
};

}  // namespace pectin

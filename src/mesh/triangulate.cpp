#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace pectin {
namespace {

// Twice the polygon's area, along its normal, whatever its shape (Newell).
Vec3 newell_normal(std::span<const Vec3> corners) {
    Vec3 sum{0.0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 p = corners[i] - corners[0];
        const Vec3 q = corners[(i + 1) % corners.size()] - corners[0];
        sum += glm::cross(p, q);
    }
    return sum;
}

double signed_area(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
    return glm::dot(glm::cross(b - a, c - a), normal);
}

void triangulate_quad(std::span<const Vec3> p, std::vector<std::array<std::uint32_t, 3>>& out) {
    const Vec3 normal = newell_normal(p);
    const bool along_02 =
        signed_area(p[0], p[1], p[2], normal) > 0.0 && signed_area(p[0], p[2], p[3], normal) > 0.0;
    const bool along_13 =
        signed_area(p[0], p[1], p[3], normal) > 0.0 && signed_area(p[1], p[2], p[3], normal) > 0.0;
    if (along_13 && !along_02) {
        out.push_back({0, 1, 3});
        out.push_back({1, 2, 3});
    } else {
        out.push_back({0, 1, 2});
        out.push_back({0, 2, 3});
    }
}

// Points of the plane in square cells, about one a cell; found by box.
class PointGrid {
  public:
    PointGrid() = default;
    explicit PointGrid(std::span<const Vec2> points) {
        Vec2 max = min_ = points.front();
        for (const Vec2& p : points) {
            min_ = glm::min(min_, p);
            max = glm::max(max, p);
        }
        const auto most = std::ceil(std::sqrt(static_cast<double>(points.size())));
        const Vec2 extent = glm::max(max - min_, Vec2{1e-300});
        size_ = static_cast<std::int64_t>(most);
        per_unit_ = most / extent;
        first_.assign(static_cast<std::size_t>(size_ * size_) + 1, 0);
        for (const Vec2& p : points) ++first_[cell_of(p) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
        points_.resize(points.size());
        for (std::uint32_t i = 0; i < points.size(); ++i) points_[at[cell_of(points[i])]++] = i;
    }

    // Whether holds(i) for any point i in the cells that the box meets. Adds to `work` what it
    // looked at.
    template <typename Holds>
    bool any_in(const Vec2& low, const Vec2& high, std::uint64_t& work, Holds holds) const {
        const auto [x0, y0] = column_and_row(low);
        const auto [x1, y1] = column_and_row(high);
        for (std::int64_t y = y0; y <= y1; ++y) {
            const std::size_t begin = first_[static_cast<std::size_t>(y * size_ + x0)];
            const std::size_t end = first_[static_cast<std::size_t>(y * size_ + x1) + 1];
            work += end - begin + 1;
            for (std::size_t i = begin; i < end; ++i) {
                if (holds(points_[i])) return true;
            }
        }
        return false;
    }

  private:
    std::pair<std::int64_t, std::int64_t> column_and_row(const Vec2& p) const {
        const Vec2 cells = (p - min_) * per_unit_;
        const auto clamped = [this](double c) {  // 0 also where huge numbers have none
            const auto last = static_cast<double>(size_ - 1);
            return c > 0.0 ? static_cast<std::int64_t>(std::min(c, last)) : 0;
        };
        return {clamped(cells.x), clamped(cells.y)};
    }
    std::size_t cell_of(const Vec2& p) const {
        const auto [x, y] = column_and_row(p);
        return static_cast<std::size_t>(y * size_ + x);
    }

    Vec2 min_{0.0}, per_unit_{0.0};
    std::int64_t size_ = 0;
    std::vector<std::uint32_t> first_;   // n_cells + 1; into points_
    std::vector<std::uint32_t> points_;  // by cell
};

// Cuts ears off a ring of corners until a triangle is left.
class EarClipper {
  public:
    explicit EarClipper(std::span<const Vec3> corners)
        : corners_(corners),
          normal_(newell_normal(corners)),
          next_(corners.size()),
          prev_(corners.size()),
          is_reflex_(corners.size()) {
        const auto n = static_cast<std::uint32_t>(corners.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            prev_[i] = (i + n - 1) % n;
        }
        std::vector<Vec2> reflex;
        drop_axis();
        for (std::uint32_t i = 0; i < n; ++i) {
            if (is_convex(i)) continue;
            is_reflex_[i] = true;
            reflex_.push_back(i);
            reflex.push_back(flat(i));
        }
        reflex_left_ = reflex_.size();
        if (!reflex.empty()) grid_ = PointGrid(reflex);
    }

    void clip(std::vector<std::array<std::uint32_t, 3>>& out) {
        std::size_t left = corners_.size();
        std::uint32_t at = 1;
        std::size_t tried = 0;
        while (left > 3) {
            // Where no corner is an ear (a polygon that crosses itself), cut the next one anyway.
            if (tried < left && !is_ear(at)) {
                at = next_[at];
                ++tried;
                continue;
            }
            const std::uint32_t before = prev_[at], after = next_[at];
            out.push_back({before, at, after});
            next_[before] = after;
            prev_[after] = before;
            forget_reflex(at);
            for (std::uint32_t r : {before, after}) {
                if (is_reflex_[r] && is_convex(r)) forget_reflex(r);
            }
            // Go on beside it: a convex polygon becomes a fan.
            at = after == 0 ? next_[after] : after;
            tried = 0;
            --left;
        }
        out.push_back({prev_[at], at, next_[at]});
    }

  private:
    // Looks at points and corners before what is left is cut as it comes: simple polygons of any
    // use stay far below, large ones that cross themselves do not.
    static std::uint64_t most_work(std::uint64_t corners) {
        return 50 * corners + 1000 * std::min(corners, std::uint64_t{20'000});
    }

    bool is_convex(std::uint32_t i) const {
        return signed_area(corners_[prev_[i]], corners_[i], corners_[next_[i]], normal_) > 0.0;
    }
    bool is_ear(std::uint32_t i) {
        if (++work_ > most_work(corners_.size())) return true;
        if (!is_convex(i)) return false;
        if (reflex_left_ == 0) return true;
        const std::uint32_t before = prev_[i], after = next_[i];
        const Vec3 &a = corners_[before], &b = corners_[i], &c = corners_[after];
        const Vec2 u = flat(before), v = flat(i), w = flat(after);
        return !grid_.any_in(
            glm::min(u, glm::min(v, w)), glm::max(u, glm::max(v, w)), work_, [&](std::uint32_t k) {
                const std::uint32_t r = reflex_[k];
                if (!is_reflex_[r] || r == before || r == i || r == after) return false;
                const Vec3& p = corners_[r];
                if (p == a || p == b || p == c) return false;
                return signed_area(a, b, p, normal_) >= 0.0 &&
                       signed_area(b, c, p, normal_) >= 0.0 && signed_area(c, a, p, normal_) >= 0.0;
            });
    }
    void forget_reflex(std::uint32_t i) {
        if (!is_reflex_[i]) return;
        is_reflex_[i] = false;
        --reflex_left_;
    }
    // For the grid: the plane's two axes that face the polygon most.
    void drop_axis() {
        const Vec3 size = glm::abs(normal_);
        const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        axes_ = {dropped == 0 ? 1 : 0, dropped == 2 ? 1 : 2};
    }
    Vec2 flat(std::uint32_t i) const { return {corners_[i][axes_[0]], corners_[i][axes_[1]]}; }

    std::span<const Vec3> corners_;
    Vec3 normal_;
    std::array<int, 2> axes_{};
    std::vector<std::uint32_t> next_, prev_;
    std::vector<bool> is_reflex_;
    std::vector<std::uint32_t> reflex_;  // as they were at the beginning; the points of the grid
    PointGrid grid_;
    std::size_t reflex_left_ = 0;
    std::uint64_t work_ = 0;
};

}  // namespace

void triangulate(std::span<const Vec3> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
    } else if (corners.size() == 4) {
        triangulate_quad(corners, triangles);
    } else {
        EarClipper(corners).clip(triangles);
    }
}

}  // namespace pectin

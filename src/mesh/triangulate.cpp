#include "mesh/triangulate.h"

#include <algorithm>
#include <numeric>

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

// Cuts ears off a ring of corners until a triangle is left.
class EarClipper {
  public:
    explicit EarClipper(std::span<const Vec3> corners)
        : corners_(corners),
          normal_(newell_normal(corners)),
          next_(corners.size()),
          prev_(corners.size()) {
        const auto n = static_cast<std::uint32_t>(corners.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            prev_[i] = (i + n - 1) % n;
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            if (!is_convex(i)) reflex_.push_back(i);
        }
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
            std::erase_if(reflex_, [&](std::uint32_t r) {
                return r == at || ((r == before || r == after) && is_convex(r));
            });
            // Go on beside it: a convex polygon becomes a fan.
            at = after == 0 ? next_[after] : after;
            tried = 0;
            --left;
        }
        out.push_back({prev_[at], at, next_[at]});
    }

  private:
    bool is_convex(std::uint32_t i) const {
        return signed_area(corners_[prev_[i]], corners_[i], corners_[next_[i]], normal_) > 0.0;
    }
    bool is_ear(std::uint32_t i) const {
        if (!is_convex(i)) return false;
        const std::uint32_t before = prev_[i], after = next_[i];
        const Vec3 &a = corners_[before], &b = corners_[i], &c = corners_[after];
        return std::none_of(reflex_.begin(), reflex_.end(), [&](std::uint32_t r) {
            if (r == before || r == i || r == after) return false;
            const Vec3& p = corners_[r];
            if (p == a || p == b || p == c) return false;
            return signed_area(a, b, p, normal_) >= 0.0 && signed_area(b, c, p, normal_) >= 0.0 &&
                   signed_area(c, a, p, normal_) >= 0.0;
        });
    }

    std::span<const Vec3> corners_;
    Vec3 normal_;
    std::vector<std::uint32_t> next_, prev_;
    std::vector<std::uint32_t> reflex_;
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

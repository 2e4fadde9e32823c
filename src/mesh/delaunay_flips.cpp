#include "mesh/delaunay_flips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/orientation.h"

namespace pectin {
namespace {

// Sines, and relative squared lengths, that differ by less than this count as equal.
constexpr double kEqual = 1e-7;
// On flat polygons the flips terminate by themselves. On others the angles in space agree with no
// plane, so the number of flips per corner is limited.
constexpr std::size_t kMostFlips = 64;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Flipper {
  public:
    Flipper(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles)
        : polygon_(polygon), triangles_(triangles), twin_(3 * triangles.size(), kNone) {}

    void flip() {
        link_twins();
        for (std::uint32_t h = 0; h < twin_.size(); ++h) queue(h);
        std::size_t flips = kMostFlips * triangles_.size();
        while (!waiting_.empty() && flips > 0) {
            const std::uint32_t h = waiting_.back();
            waiting_.pop_back();
            if (twin_[h] == kNone || !is_worse(h)) continue;
            flip(h);
            --flips;
        }
    }

  private:
    // Half-edge 3 t + k runs from corner k of triangle t to the next corner.
    static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static std::uint32_t prev(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    std::uint32_t& origin(std::uint32_t h) { return triangles_[h / 3][h % 3]; }
    std::uint32_t origin(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
    void queue(std::uint32_t h) {
        if (twin_[h] != kNone && h < twin_[h]) waiting_.push_back(h);
    }

    // Between a pair of corners there are two half-edges (a diagonal) or one (a side).
    void link_twins() {
        std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> sorted;
        for (std::uint32_t h = 0; h < twin_.size(); ++h) {
            sorted.push_back({std::minmax(origin(h), origin(next(h))), h});
        }
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            if (sorted[i].first == sorted[i - 1].first)
                link(sorted[i].second, sorted[i - 1].second);
        }
    }
    void link(std::uint32_t g, std::uint32_t h) {
        if (g != kNone) twin_[g] = h;
        if (h != kNone) twin_[h] = g;
    }

    //       c            Compares the angles opposite to the diagonal h = ab: at c in its own
    //     /   \          triangle, and at d in the other one.
    //    a --- b
    //     \   /
    //       d
    bool is_worse(std::uint32_t h) const {
        const std::uint32_t a = origin(h), b = origin(next(h)), c = origin(prev(h)),
                            d = origin(prev(twin_[h]));
        const auto& p = polygon_.in_space;
        const Vec3 ca = p[a] - p[c], cb = p[b] - p[c], da = p[a] - p[d], db = p[b] - p[d];
        const double cos_c = glm::dot(ca, cb), sin_c = glm::length(glm::cross(ca, cb));
        const double cos_d = glm::dot(da, db), sin_d = glm::length(glm::cross(da, db));
        const double scale =
            glm::length(ca) * glm::length(cb) * (glm::length(da) * glm::length(db));
        const double sine =
            sin_c * cos_d + cos_c * sin_d;  // sine of the sum of both angles, times the scale
        if (sine > kEqual * scale) return false;
        if (sine >= -kEqual * scale) {
            const Vec3 ab = p[b] - p[a], cd = p[d] - p[c];
            if (glm::dot(cd, cd) >= (1.0 - kEqual) * glm::dot(ab, ab)) return false;
        }
        const auto& q = polygon_.points;
        return orientation(q[c], q[a], q[d]) > 0 && orientation(q[d], q[b], q[c]) > 0;
    }

    // Replaces abc and bad by dca (in the slot of abc) and cdb.
    void flip(std::uint32_t h) {
        const std::uint32_t g = twin_[h];
        const std::uint32_t bc = twin_[next(h)], ca = twin_[prev(h)];
        const std::uint32_t ad = twin_[next(g)], db = twin_[prev(g)];
        const std::uint32_t c = origin(prev(h)), d = origin(prev(g));
        origin(next(h)) = d;  // h: a -> d, d -> c, c -> a
        origin(next(g)) = c;  // g: b -> c, c -> d, d -> b
        link(h, ad);
        link(g, bc);
        link(prev(h), ca);
        link(prev(g), db);
        link(next(h), next(g));
        for (std::uint32_t side : {h, prev(h), g, prev(g)}) {
            if (twin_[side] != kNone) waiting_.push_back(side);
        }
    }

    const FlatPolygon& polygon_;
    std::vector<CornerTriangle>& triangles_;
    std::vector<std::uint32_t> twin_;  // one per half-edge; none on the polygon's sides
    std::vector<std::uint32_t> waiting_;
};

}  // namespace

void flip_to_delaunay(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles) {
    Flipper(polygon, triangles).flip();
}

}  // namespace pectin

#include "mesh/delaunay_flips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/orientation.h"

namespace pectin {
namespace {

// Smaller sines count as zero.
constexpr double kEqual = 1e-7;
// The flips terminate by themselves, but some polygons need n^2 of them. Each pass ends after this
// number of flips per triangle.
constexpr std::size_t kMostFlips = 64;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Flipper {
  public:
    Flipper(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles)
        : polygon_(polygon), triangles_(triangles), twin_(3 * triangles.size(), kNone) {}

    // Adds the triangles one by one, from the last to the first, and flips among those added.
    std::size_t flip() {
        link_twins();
        const std::size_t most = kMostFlips * triangles_.size();
        std::size_t flips = 0;
        for (auto first = static_cast<std::uint32_t>(triangles_.size()); first-- > 0;) {
            waiting_ = {3 * first, 3 * first + 1, 3 * first + 2};
            while (!waiting_.empty() && flips < most) {
                const std::uint32_t h = waiting_.back();
                waiting_.pop_back();
                const bool is_inside = twin_[h] != kNone && twin_[h] >= 3 * first;
                if (!is_inside || sine_of_sum(h) >= -kEqual || !is_convex(h)) continue;
                flip(h);
                ++flips;
            }
        }
        return flips;
    }

    // Triangulates again the groups of triangles whose corners lie on one circle, since they have
    // several Delaunay triangulations. Returns whether there are any.
    bool cut_circles() {
        std::vector<bool> is_tied(twin_.size(), false), is_met(triangles_.size(), false);
        bool any_tied = false;
        for (std::uint32_t h = 0; h < twin_.size(); ++h) {
            if (twin_[h] == kNone || h > twin_[h] || std::abs(sine_of_sum(h)) > kEqual) continue;
            any_tied = is_tied[h] = is_tied[twin_[h]] = true;
        }
        for (std::uint32_t h = 0; any_tied && h < twin_.size(); ++h) {
            if (!is_tied[h] || is_met[h / 3]) continue;
            const std::vector<std::uint32_t> members = joined_to(h / 3, is_tied, is_met);
            cut_circle(members, outline_of(members, is_tied));
        }
        return any_tied;
    }

  private:
    // Half-edge 3 t + k runs from corner k of triangle t to the next corner.
    static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static std::uint32_t prev(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    std::uint32_t& origin(std::uint32_t h) { return triangles_[h / 3][h % 3]; }
    std::uint32_t origin(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
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
    // Returns the sine of their sum: negative if it is more than two right angles.
    double sine_of_sum(std::uint32_t h) const {
        const std::uint32_t a = origin(h), b = origin(next(h)), c = origin(prev(h)),
                            d = origin(prev(twin_[h]));
        const auto& p = polygon_.in_plane;
        const Vec3 ca = p[a] - p[c], cb = p[b] - p[c], da = p[a] - p[d], db = p[b] - p[d];
        const double cos_c = glm::dot(ca, cb), sin_c = glm::length(glm::cross(ca, cb));
        const double cos_d = glm::dot(da, db), sin_d = glm::length(glm::cross(da, db));
        const double scale =
            glm::length(ca) * glm::length(cb) * (glm::length(da) * glm::length(db));
        return scale > 0.0 ? (sin_c * cos_d + cos_c * sin_d) / scale : 1.0;
    }
    bool is_convex(std::uint32_t h) const {
        const std::uint32_t a = origin(h), b = origin(next(h)), c = origin(prev(h)),
                            d = origin(prev(twin_[h]));
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

    // The triangles that are connected with t across tied diagonals.
    std::vector<std::uint32_t> joined_to(std::uint32_t t, const std::vector<bool>& is_tied,
                                         std::vector<bool>& is_met) const {
        std::vector<std::uint32_t> members{t};
        is_met[t] = true;
        for (std::size_t i = 0; i < members.size(); ++i) {
            for (std::uint32_t h = 3 * members[i]; h < 3 * members[i] + 3; ++h) {
                if (!is_tied[h] || is_met[twin_[h] / 3]) continue;
                is_met[twin_[h] / 3] = true;
                members.push_back(twin_[h] / 3);
            }
        }
        return members;
    }
    // The corners of the group of triangles, in order.
    std::vector<std::uint32_t> outline_of(const std::vector<std::uint32_t>& members,
                                          const std::vector<bool>& is_tied) const {
        const auto next_outside = [&](std::uint32_t h) {
            while (is_tied[h]) h = next(twin_[h]);
            return h;
        };
        const std::uint32_t first = next_outside(3 * members.front());
        std::vector<std::uint32_t> outline{origin(first)};
        for (std::uint32_t h = next_outside(next(first)); h != first; h = next_outside(next(h))) {
            outline.push_back(origin(h));
        }
        return outline;
    }
    void cut_circle(const std::vector<std::uint32_t>& members,
                    const std::vector<std::uint32_t>& outline) {
        FlatPolygon inside;
        for (const std::uint32_t corner : outline) {
            inside.points.push_back(polygon_.points[corner]);
            inside.in_space.push_back(polygon_.in_space[corner]);
            inside.order.push_back(polygon_.order[corner]);
        }
        const auto ears = clip_ears(inside, most_ear_steps(outline.size()));
        if (!ears) return;
        const auto has_area = [&](const CornerTriangle& t) {
            return orientation(inside.points[t[0]], inside.points[t[1]], inside.points[t[2]]) > 0;
        };
        if (!std::all_of(ears->begin(), ears->end(), has_area)) return;
        for (std::size_t i = 0; i < members.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) triangles_[members[i]][k] = outline[(*ears)[i][k]];
        }
    }

    const FlatPolygon& polygon_;
    std::vector<CornerTriangle>& triangles_;
    std::vector<std::uint32_t> twin_;  // one per half-edge; none on the polygon's sides
    std::vector<std::uint32_t> waiting_;
};

}  // namespace

std::size_t flip_to_delaunay(const FlatPolygon& polygon, std::vector<CornerTriangle>& triangles) {
    Flipper flipper(polygon, triangles);
    std::size_t flips = flipper.flip();
    // Corners that lie on one circle quad by quad, up to the tolerance, may lie on another curve.
    if (flipper.cut_circles()) flips += Flipper(polygon, triangles).flip();
    return flips;
}

}  // namespace pectin

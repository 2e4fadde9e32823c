#include "mesh/ear_clipping.h"

#include <bit>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "geometry/binary_digits.h"
#include "geometry/orientation.h"
#include "mesh/point_tree.h"

namespace pectin {
namespace {

// The rules for what counts as an ear, from strict ones, which suffice for simple polygons, to
// those for the remainder of a polygon that intersects itself.
enum class Rule { proper, touched, flat, any };

// Polygons that do not intersect themselves never need to relax the rule as often as this.
constexpr int kMostEasings = 16;

class EarClipper {
  public:
    EarClipper(const FlatPolygon& polygon, std::size_t most_steps)
        : polygon_(polygon),
          most_steps_(most_steps),
          next_(polygon.points.size()),
          prev_(polygon.points.size()),
          version_(polygon.points.size(), 0),
          is_blocker_(polygon.points.size(), false),
          left_(polygon.points.size()),
          blockers_(link_corners()) {}

    std::optional<std::vector<CornerTriangle>> clip() {
        triangles_.reserve(polygon_.points.size());
        push_all();
        while (left_ > 3) {
            if (steps_ > most_steps_) return std::nullopt;
            if (ears_.empty()) {
                ease_rule();
                continue;
            }
            const Ear ear = ears_.top();
            ears_.pop();
            const bool is_current = version_[ear.tip] == ear.version;
            if (is_current && is_ear(ear.tip)) clip_ear(ear.tip);
        }
        triangles_.push_back({prev_[last_], last_, next_[last_]});
        return std::move(triangles_);
    }

    std::vector<CornerTriangle> clip_without_search() {
        rule_ = Rule::any;
        easings_ = kMostEasings;
        return *clip();
    }

  private:
    struct Ear {
        std::uint32_t length = 0;  // of the diagonal, as bits of a float: coarse enough that
                                   // lengths which rounding has made different are equal
        std::uint32_t order = 0, tip = 0, version = 0;
        bool operator>(const Ear& o) const {
            return std::tie(length, order, tip) > std::tie(o.length, o.order, o.tip);
        }
    };

    const Vec2& point(std::uint32_t i) const { return polygon_.points[i]; }
    int turn(std::uint32_t i) const {
        return orientation(point(prev_[i]), point(i), point(next_[i]));
    }

    // Makes a ring of the corners. Returns a tree of the corners that are not convex: if any corner
    // lies in an ear's triangle, one of these does.
    PointTree link_corners() {
        const auto n = static_cast<std::uint32_t>(polygon_.points.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            prev_[i] = (i + n - 1) % n;
        }
        std::vector<std::uint32_t> blockers;
        for (std::uint32_t i = 0; i < n; ++i) {
            if (turn(i) > 0) continue;
            is_blocker_[i] = true;
            blockers.push_back(i);
        }
        return {polygon_.points, std::move(blockers)};
    }

    // Whether corner i, which was convex, has become flat, with no area between its sides.
    bool is_spike(std::uint32_t i) const { return !is_blocker_[i] && turn(i) == 0; }

    void push(std::uint32_t tip) {
        const Vec3 diagonal = polygon_.in_space[next_[tip]] - polygon_.in_space[prev_[tip]];
        const auto squared = static_cast<float>(is_spike(tip) ? 0.0 : glm::dot(diagonal, diagonal));
        constexpr std::uint32_t kEqual = (1u << 10) - 1;  // 2^-13 of a squared length
        ears_.push({std::bit_cast<std::uint32_t>(squared) & ~kEqual, polygon_.order[tip], tip,
                    ++version_[tip]});
    }
    void push_all() {
        std::uint32_t i = last_;
        do push(i);
        while ((i = next_[i]) != last_);
    }

    bool is_ear(std::uint32_t i) {
        if (rule_ == Rule::any || is_spike(i)) return true;
        const int turned = turn(i);
        if (turned < 0 || (turned == 0 && rule_ < Rule::flat)) return false;
        if (blockers_.is_empty() || turned == 0) return true;
        const std::uint32_t before = prev_[i], after = next_[i];
        const Vec2 &a = point(before), &b = point(i), &c = point(after);
        const int least =
            rule_ == Rule::proper ? 0 : 1;  // whether a point on a side blocks the ear
        return !blockers_.any_near({a, b, c}, steps_, [&](std::uint32_t r) {
            const Vec2& p = point(r);
            if (p == a) return leads_between(r, b, c);
            if (p == b) return leads_between(r, c, a);
            if (p == c) return leads_between(r, a, b);
            return orientation(a, b, p) >= least && orientation(b, c, p) >= least &&
                   orientation(c, a, p) >= least;
        });
    }
    // Whether a side at corner r leads into the open angle counter-clockwise from `first` to
    // `second`. Precondition: the angle is less than two right angles.
    bool leads_between(std::uint32_t r, const Vec2& first, const Vec2& second) const {
        const auto lies_between = [&](const Vec2& p) {
            return orientation(point(r), first, p) > 0 && orientation(second, point(r), p) > 0;
        };
        return lies_between(point(prev_[r])) || lies_between(point(next_[r]));
    }

    void clip_ear(std::uint32_t i) {
        const std::uint32_t before = prev_[i], after = next_[i];
        triangles_.push_back({before, i, after});
        next_[before] = after;
        prev_[after] = before;
        ++version_[i];
        stop_blocking(i);
        for (std::uint32_t r : {before, after}) {
            if (turn(r) > 0) stop_blocking(r);
            push(r);
        }
        last_ = after;
        --left_;
        has_clipped_ = true;
        if (rule_ == Rule::any && easings_ < kMostEasings) restart(Rule::proper);
    }
    void stop_blocking(std::uint32_t i) {
        if (!is_blocker_[i]) return;
        is_blocker_[i] = false;
        blockers_.remove(i);
    }

    // Called if no corner is an ear by the current rule.
    void ease_rule() {
        if (has_clipped_ && rule_ != Rule::proper && easings_ < kMostEasings) {
            restart(Rule::proper);
        } else {
            restart(rule_ == Rule::proper    ? Rule::touched
                    : rule_ == Rule::touched ? Rule::flat
                                             : Rule::any);
        }
    }
    void restart(Rule rule) {
        rule_ = ++easings_ < kMostEasings ? rule : Rule::any;
        has_clipped_ = false;
        ears_ = {};
        push_all();
    }

    const FlatPolygon& polygon_;
    std::size_t most_steps_, steps_ = 0;  // nodes visited in searches for blocking corners
    std::vector<std::uint32_t> next_, prev_;
    std::vector<std::uint32_t> version_;  // ears of an earlier version are out of date
    std::vector<bool> is_blocker_;
    std::size_t left_;
    PointTree blockers_;
    std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears_;
    std::vector<CornerTriangle> triangles_;
    std::uint32_t last_ = 0;  // a corner that has not been cut off
    Rule rule_ = Rule::proper;
    bool has_clipped_ = false;  // since the last change of the rule
    int easings_ = 0;
};

}  // namespace

std::optional<std::vector<CornerTriangle>> clip_ears(const FlatPolygon& polygon,
                                                     std::size_t most_steps) {
    return EarClipper(polygon, most_steps).clip();
}

std::vector<CornerTriangle> clip_ears(const FlatPolygon& polygon) {
    return *clip_ears(polygon, std::numeric_limits<std::size_t>::max());
}

std::size_t most_ear_steps(std::size_t corners) {
    constexpr std::size_t kPerCornerAndBit = 16;
    return corners <= kMostCornersOfSmall ? std::numeric_limits<std::size_t>::max()
                                          : kPerCornerAndBit * corners * binary_digits(corners);
}

std::vector<CornerTriangle> clip_corners(const FlatPolygon& polygon) {
    return EarClipper(polygon, std::numeric_limits<std::size_t>::max()).clip_without_search();
}

}  // namespace pectin

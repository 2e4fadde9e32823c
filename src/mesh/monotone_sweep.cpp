#include "mesh/monotone_sweep.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/orientation.h"

namespace pectin {
namespace {

enum class Bound { lower, upper };

// The corners along one bound of a monotone piece that still lack triangles, from left to right.
// The first is the left end of the piece or lies on its other bound. No triangle of three
// successive corners lies inside the polygon.
struct Chain {
    Bound bound = Bound::lower;
    std::vector<std::uint32_t> corners;
};

// An interval of the sweep line inside the polygon, between two sides. Side i runs from corner i to
// the next one; lower sides run to the right, upper ones to the left.
struct Interval {
    std::uint32_t lower = 0, upper = 0;
    Chain chain;
    // If two intervals have merged at a corner, and no corner has been passed since: the chain
    // above that corner; `chain` is then the one below it. Otherwise empty.
    Chain above;
    bool has_two_pieces() const { return !above.corners.empty(); }
};

class Sweep {
  public:
    Sweep(std::span<const Vec2> points, std::span<const Vec2> directions)
        : points_(points), directions_(directions), interval_of_(points.size(), intervals_.end()) {}

    std::optional<SweptPolygon> run() {
        const auto n = static_cast<std::uint32_t>(points_.size());
        std::vector<std::uint32_t> order(n);
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t i, std::uint32_t j) { return is_left_of(i, j); });
        for (std::size_t i = 0; i < order.size() && is_simple_; ++i) {
            if (i > 0 && !is_left_of(order[i - 1], order[i])) return std::nullopt;  // equal
            pass(order[i]);
        }
        if (!is_simple_ || result_.triangles.size() != points_.size() - 2) return std::nullopt;
        return std::move(result_);
    }

  private:
    using Pointer = std::unique_ptr<Interval>;
    // Orders intervals from the lowest to the highest. Replacing a bound keeps the order.
    struct IsBelow {
        using is_transparent = void;
        Sweep* sweep;
        // The lower side that begins later begins at the sweep line.
        bool operator()(const Pointer& i, const Pointer& j) const {
            if (sweep->is_left_of(i->lower, j->lower)) return sweep->is_below(i->lower, j->lower);
            return i != j && !sweep->is_below(j->lower, i->lower);
        }
        bool operator()(const Pointer& i, std::uint32_t corner) const {
            return sweep->is_below(i->lower, corner);
        }
    };
    using Intervals = std::set<Pointer, IsBelow>;
    using Place = Intervals::iterator;

    std::uint32_t next(std::uint32_t i) const { return i + 1 < points_.size() ? i + 1 : 0; }
    std::uint32_t prev(std::uint32_t i) const {
        return i > 0 ? i - 1 : static_cast<std::uint32_t>(points_.size() - 1);
    }
    bool is_left_of(std::uint32_t i, std::uint32_t j) const {
        const auto is_less = [](const Vec2& p, const Vec2& q) {
            return std::tie(p.x, p.y) < std::tie(q.x, q.y);
        };
        const bool directions_decide = !directions_.empty() && points_[i] == points_[j];
        return directions_decide ? is_less(directions_[i], directions_[j])
                                 : is_less(points_[i], points_[j]);
    }
    int turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        ++result_.steps;
        const int turned = orientation(points_[i], points_[j], points_[k]);
        if (turned != 0 || directions_.empty()) return turned;
        const auto moving = [&](std::uint32_t c) {
            return MovingPoint{points_[c], directions_[c]};
        };
        return orientation(moving(i), moving(j), moving(k));
    }
    // Compares a side that the sweep line meets with a corner on that line.
    bool is_below(std::uint32_t side, std::uint32_t corner) {
        std::uint32_t left = side, right = next(side);
        if (is_left_of(right, left)) std::swap(left, right);
        const int turned = turn(left, right, corner);
        is_simple_ = is_simple_ && turned != 0;
        return turned > 0;
    }

    void pass(std::uint32_t v) {
        const std::uint32_t before = prev(v), after = next(v);
        const bool comes_from_left = is_left_of(before, v), leads_left = is_left_of(after, v);
        if (comes_from_left && leads_left) {
            interval_of_[before] == interval_of_[v] ? end(v) : merge(v);
        } else if (comes_from_left) {
            move_bound(v, Bound::lower);
        } else if (leads_left) {
            move_bound(v, Bound::upper);
        } else {
            open(v);
        }
    }

    //    \ .          The side that begins at v replaces the one that ends there.
    //     v----
    void move_bound(std::uint32_t v, Bound bound) {
        const std::uint32_t ending = bound == Bound::lower ? prev(v) : v;
        const std::uint32_t beginning = bound == Bound::lower ? v : prev(v);
        const Place place = interval_of_[ending];
        Interval& interval = **place;
        add(interval, v, bound);
        (bound == Bound::lower ? interval.lower : interval.upper) = beginning;
        interval_of_[beginning] = place;
    }

    //      /          v begins an interval, or divides an existing one.
    //     v
    //      \ .
    void open(std::uint32_t v) {
        const Place above = intervals_.lower_bound(v);
        const bool is_convex = turn(prev(v), v, next(v)) > 0;
        const bool has_below = above != intervals_.begin();
        const bool is_inside = has_below && !is_below((*std::prev(above))->upper, v);
        is_simple_ = is_simple_ && is_inside != is_convex;
        if (!is_simple_) return;
        auto opened = std::make_unique<Interval>(
            Interval{.lower = v, .upper = prev(v), .chain = {Bound::lower, {v}}, .above = {}});
        if (is_inside) split(**std::prev(above), v, *opened);
        const Place place = intervals_.insert(above, std::move(opened));
        interval_of_[(*place)->lower] = interval_of_[(*place)->upper] = place;
    }
    // Leaves in `below` the part below v, and moves the part above it to `opened`.
    void split(Interval& below, std::uint32_t v, Interval& opened) {
        std::swap(below.upper, opened.upper);
        const std::uint32_t last = below.chain.corners.back();
        interval_of_[below.upper] = interval_of_[below.lower];
        if (below.has_two_pieces()) {
            opened.chain = std::exchange(below.above, {});
            extend(opened.chain, v);
            extend(below.chain, v);
        } else if (below.chain.bound == Bound::lower) {
            opened.chain = std::exchange(below.chain, {Bound::upper, {last, v}});
            extend(opened.chain, v);
        } else {
            opened.chain = {Bound::lower, {last, v}};
            extend(below.chain, v);
        }
    }

    //     \           The intervals above and below v merge.
    //      v
    //     /
    void merge(std::uint32_t v) {
        const Place above = interval_of_[prev(v)], below = interval_of_[v];
        is_simple_ = is_simple_ && std::next(below) == above;
        if (!is_simple_) return;
        add(**above, v, Bound::lower);
        add(**below, v, Bound::upper);
        (*below)->above = std::move((*above)->chain);
        (*below)->upper = (*above)->upper;
        interval_of_[(*above)->upper] = below;
        intervals_.erase(above);
    }
    void end(std::uint32_t v) {
        const Place place = interval_of_[v];
        close((*place)->chain, v);
        close((*place)->above, v);
        intervals_.erase(place);
    }

    // Adds a corner on one of the interval's two bounds.
    void add(Interval& interval, std::uint32_t v, Bound bound) {
        if (interval.has_two_pieces()) {
            Chain closed = std::exchange(interval.above, {});
            if (bound == Bound::lower) std::swap(interval.chain, closed);
            close(closed, v);
        }
        if (interval.chain.bound == bound) {
            extend(interval.chain, v);
        } else {
            close(interval.chain, v);
            interval.chain = {bound, {interval.chain.corners.back(), v}};
        }
    }
    // Adds a corner on the chain's bound, and cuts off all triangles that lie inside.
    void extend(Chain& chain, std::uint32_t v) {
        std::vector<std::uint32_t>& corners = chain.corners;
        const int inside = chain.bound == Bound::lower ? 1 : -1;
        while (corners.size() > 1) {
            const std::uint32_t last = corners.back(), before = corners[corners.size() - 2];
            if (turn(before, last, v) != inside) break;
            add_triangle(chain.bound, before, last, v);
            corners.pop_back();
        }
        corners.push_back(v);
    }
    // Connects all corners of the chain with one on the other bound or at the right end.
    void close(const Chain& chain, std::uint32_t v) {
        for (std::size_t i = 1; i < chain.corners.size(); ++i) {
            add_triangle(chain.bound, chain.corners[i - 1], chain.corners[i], v);
        }
    }
    void add_triangle(Bound bound, std::uint32_t a, std::uint32_t b, std::uint32_t v) {
        if (bound == Bound::upper) std::swap(a, b);
        result_.triangles.push_back({a, b, v});
    }

    std::span<const Vec2> points_;
    std::span<const Vec2> directions_;  // n; empty if the corners stay where they are
    Intervals intervals_{IsBelow{this}};
    std::vector<Place> interval_of_;  // n; the interval that a side bounds
    SweptPolygon result_;
    bool is_simple_ = true;  // no contradiction has been found
};

}  // namespace

std::optional<SweptPolygon> sweep_triangles(std::span<const Vec2> points) {
    return Sweep(points, {}).run();
}

std::optional<SweptPolygon> sweep_triangles(std::span<const Vec2> points,
                                            std::span<const Vec2> directions) {
    return Sweep(points, directions).run();
}

}  // namespace pectin

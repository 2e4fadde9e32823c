#include "mesh/touching_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/orientation.h"

namespace pectin {
namespace {

// Whether the outline repeats corner p or turns back on itself there.
bool turns_back(const Vec2& before, const Vec2& p, const Vec2& after) {
    if (p == before || p == after) return true;
    if (orientation(before, p, after) != 0) return false;
    // The three are collinear, so one coordinate tells whether both neighbours are on one side.
    return p.x != before.x ? (before.x < p.x) == (after.x < p.x)
                           : (before.y < p.y) == (after.y < p.y);
}

struct Outline {
    std::vector<std::uint32_t> corners;
    std::vector<CornerTriangle> cut_off;  // triangles without area
};

Outline without_turns_back(std::span<const Vec2> points) {
    const auto n = static_cast<std::uint32_t>(points.size());
    std::vector<std::uint32_t> next(n), prev(n), waiting(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        next[i] = (i + 1) % n;
        prev[i] = (i + n - 1) % n;
        waiting[i] = i;
    }
    std::vector<bool> is_cut_off(n, false);
    Outline outline;
    while (!waiting.empty() && outline.cut_off.size() + 3 < n) {
        const std::uint32_t i = waiting.back();
        waiting.pop_back();
        const std::uint32_t before = prev[i], after = next[i];
        if (is_cut_off[i] || !turns_back(points[before], points[i], points[after])) continue;
        outline.cut_off.push_back({before, i, after});
        is_cut_off[i] = true;
        next[before] = after;
        prev[after] = before;
        waiting.insert(waiting.end(), {before, after});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        if (!is_cut_off[i]) outline.corners.push_back(i);
    }
    return outline;
}

Vec2 unit(const Vec2& v) { return glm::normalize(v / std::max(std::abs(v.x), std::abs(v.y))); }

// A direction that halves the angle to the left of the outline at p. Precondition: the outline does
// not turn back there.
Vec2 bisector(const Vec2& before, const Vec2& p, const Vec2& after) {
    const Vec2 in = unit(p - before), out = unit(after - p);
    if (glm::dot(in, out) >= 0.0) return {-(in.y + out.y), in.x + out.x};
    return orientation(before, p, after) > 0 ? out - in : in - out;
}

}  // namespace

std::optional<SweptPolygon> sweep_touching_polygon(std::span<const Vec2> points, Touch touch) {
    Outline outline = without_turns_back(points);
    const std::size_t n = outline.corners.size();
    if (n <= 3) return std::nullopt;
    std::vector<Vec2> kept, directions;
    for (const std::uint32_t corner : outline.corners) kept.push_back(points[corner]);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 inwards = bisector(kept[(i + n - 1) % n], kept[i], kept[(i + 1) % n]);
        directions.push_back(touch == Touch::outside ? inwards : -inwards);
    }
    std::optional<SweptPolygon> swept = sweep_triangles(kept, directions);
    if (!swept) return std::nullopt;
    for (CornerTriangle& t : swept->triangles) {
        for (std::uint32_t& corner : t) corner = outline.corners[corner];
    }
    swept->triangles.insert(swept->triangles.end(), outline.cut_off.begin(), outline.cut_off.end());
    return swept;
}

}  // namespace pectin

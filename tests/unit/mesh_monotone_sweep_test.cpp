// Tests the triangulation of large polygons by a plane sweep: the triangles cover the polygon, and
// the number of steps grows like n log n even where finding ears takes more.
#include "mesh/monotone_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>

#include "geometry/binary_digits.h"
#include "geometry/orientation.h"
#include "mesh/delaunay_flips.h"
#include "mesh/triangulate.h"
#include "support/polygon_area.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::area_of;
using test::Random;
using Ring = std::vector<Vec2>;

std::vector<Vec3> in_space(const Ring& ring) {
    std::vector<Vec3> corners;
    for (const Vec2& p : ring) corners.push_back({p, 0.0});
    return corners;
}
FlatPolygon flat(const Ring& ring) {
    FlatPolygon polygon{ring, in_space(ring), in_space(ring),
                        std::vector<std::uint32_t>(ring.size())};
    std::iota(polygon.order.begin(), polygon.order.end(), 0u);
    return polygon;
}

// Expects n - 2 counter-clockwise triangles. Each side of the polygon occurs once, and each
// diagonal twice, once in each direction.
void expect_cover(const Ring& ring, const std::vector<CornerTriangle>& triangles) {
    const auto n = static_cast<std::uint32_t>(ring.size());
    ASSERT_EQ(triangles.size(), n - 2u);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (std::uint32_t i = 0; i < n; ++i) --sides[{i, (i + 1) % n}];
    double sum = 0.0;
    for (const CornerTriangle& t : triangles) {
        EXPECT_GE(orientation(ring[t[0]], ring[t[1]], ring[t[2]]), 0);
        sum += area_of(ring[t[0]], ring[t[1]], ring[t[2]]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = t[k], to = t[(k + 1) % 3];
            const bool is_side = to == (from + 1) % n;
            sides[is_side ? std::pair(from, to)
                          : std::pair(std::min(from, to), std::max(from, to))] +=
                is_side || from < to ? 1 : -1;
        }
    }
    for (const auto& [side, count] : sides) EXPECT_EQ(count, 0) << side.first << '-' << side.second;
    EXPECT_NEAR(sum, area_of(ring), 1e-12 * area_of(ring));
}

// A flat base with teeth of random height.
Ring sawtooth(int corners, Random& random) {
    Ring ring{{0, 0}, {1, 0}};
    for (int i = corners - 2; i-- > 0;)
        ring.push_back({(i + 0.5) / corners, random.uniform(0.01, 1)});
    return ring;
}
Ring star(int corners, Random& random) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
        const double a = 2.0 * std::numbers::pi * i / corners, r = random.uniform(0.1, 1.0);
        ring.push_back({r * std::cos(a), r * std::sin(a)});
    }
    return ring;
}
// An ellipse whose axes are rotated, so that the triangles of the sweep are far from Delaunay
// triangles.
Ring ellipse(int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
        const double a = 2.0 * std::numbers::pi * i / corners, x = std::cos(a),
                     y = 0.3 * std::sin(a);
        ring.push_back({0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y});
    }
    return ring;
}

TEST(MonotoneSweep, CoversRandomPolygonsFromEveryFirstCorner) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        const int n = random.integer(3, 40);
        Ring ring = random.chance(0.5) && n > 4 ? sawtooth(n, random) : star(n, random);
        const double angle = random.chance(0.3) ? 0.5 * std::numbers::pi * random.integer(0, 3)
                                                : random.uniform(0, 2.0 * std::numbers::pi);
        for (Vec2& p : ring) {
            p = {p.x * std::cos(angle) - p.y * std::sin(angle),
                 p.x * std::sin(angle) + p.y * std::cos(angle)};
        }
        std::rotate(ring.begin(), ring.begin() + random.integer(0, n - 1), ring.end());
        if (area_of(ring) < 0.0) continue;  // a triangle that does not contain the origin
        const auto swept = sweep_triangles(ring);
        ASSERT_TRUE(swept.has_value());
        expect_cover(ring, swept->triangles);
        if (HasFailure()) return;
    }
}

TEST(MonotoneSweep, TakesCornersAboveEachOther) {
    // A plus sign that consists of squares. All its sides are vertical or horizontal.
    const Ring plus{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                    {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    const auto swept = sweep_triangles(plus);
    ASSERT_TRUE(swept.has_value());
    expect_cover(plus, swept->triangles);
}

TEST(MonotoneSweep, LeavesPolygonsThatTouchThemselvesToEars) {
    EXPECT_FALSE(sweep_triangles(Ring{{0, 0}, {4, 0}, {4, 4}, {1, 1}, {4, 4}, {0, 4}}));
    EXPECT_FALSE(sweep_triangles(Ring{{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
}

TEST(MonotoneSweep, StepsGrowLikeNLogN) {
    Random random(6);
    const auto expect_few = [](const Ring& ring) {
        const auto swept = sweep_triangles(ring);
        ASSERT_TRUE(swept.has_value());
        std::vector<CornerTriangle> triangles = swept->triangles;
        EXPECT_LT(swept->steps, ring.size() * binary_digits(ring.size()));
        EXPECT_LT(flip_to_delaunay(flat(ring), triangles), ring.size());
        double area = 0.0;
        for (const CornerTriangle& t : triangles) {
            EXPECT_GE(orientation(ring[t[0]], ring[t[1]], ring[t[2]]), 0);
            area += area_of(ring[t[0]], ring[t[1]], ring[t[2]]);
        }
        EXPECT_NEAR(area, area_of(ring), 1e-12);
        // The number of steps of the search for ears grows faster.
        const std::size_t most = 4 * ring.size() * binary_digits(ring.size());
        EXPECT_EQ(clip_ears(flat(ring), most).has_value(), ring.size() < 5'000) << ring.size();
    };
    for (const int corners : {2'000, 50'000, 100'000}) {
        expect_few(sawtooth(corners, random));
        expect_few(star(corners, random));
    }
}

TEST(MonotoneSweep, EarsOfSmoothCurvesNeedFewFlips) {
    for (const int corners : {1'000, 10'000, 100'000}) {
        const Ring ring = ellipse(corners);
        const FlatPolygon polygon = flat(ring);
        auto triangles = clip_ears(polygon, polygon.points.size());
        ASSERT_TRUE(triangles.has_value());
        EXPECT_LT(flip_to_delaunay(polygon, *triangles), 2 * ring.size());
    }
}

TEST(MonotoneSweep, GivesTheTrianglesThatEarsGive) {
    // Corners on a circle or on a grid allow several Delaunay triangulations.
    Random random(8);
    const auto triangles_of = [](FlatPolygon polygon, std::vector<CornerTriangle> triangles) {
        flip_to_delaunay(polygon, triangles);
        for (CornerTriangle& t : triangles) std::sort(t.begin(), t.end());
        std::sort(triangles.begin(), triangles.end());
        return triangles;
    };
    for (int i = 0; i < 100; ++i) {
        const int n = random.integer(5, 300);
        Ring ring = random.chance(0.5) ? star(n, random) : sawtooth(n, random);
        if (random.chance(0.3)) {  // corners on a circle
            ring = star(n, random);
            for (Vec2& p : ring) p /= glm::length(p);
        } else if (random.chance(0.3)) {  // corners on a grid
            ring = {{0, 0}, {n, 0}};
            for (int x = n; x >= 0; --x) ring.push_back({x, random.integer(1, 4)});
        }
        const auto swept = sweep_triangles(ring);
        ASSERT_TRUE(swept.has_value());
        const FlatPolygon polygon = flat(ring);
        ASSERT_EQ(triangles_of(polygon, swept->triangles),
                  triangles_of(polygon, clip_ears(polygon)))
            << "case " << i;
    }
}

}  // namespace
}  // namespace pectin

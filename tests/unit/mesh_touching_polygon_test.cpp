// Large polygons that touch or intersect themselves: the first are covered exactly, the others are
// reported, and the steps of both are limited.
#include "mesh/touching_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/binary_digits.h"
#include "geometry/orientation.h"
#include "mesh/ear_clipping.h"
#include "mesh/triangulate.h"
#include "support/polygon_area.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::area_of;
using test::Random;
using Ring = std::vector<Vec2>;

// No triangle is clockwise, each side belongs to one triangle and each diagonal to two.
void expect_cover(const Ring& ring, const std::vector<CornerTriangle>& triangles) {
    const auto n = static_cast<std::uint32_t>(ring.size());
    ASSERT_EQ(triangles.size(), n - 2u);
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> sides;
    double sum = 0.0;
    for (const CornerTriangle& t : triangles) {
        ASSERT_GE(orientation(ring[t[0]], ring[t[1]], ring[t[2]]), 0);
        sum += area_of(ring[t[0]], ring[t[1]], ring[t[2]]);
        for (std::size_t k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        ASSERT_EQ(sides.count({i, (i + 1) % n}), 1u) << i;
    }
    for (const auto& [from, to] : sides) {
        if (to != (from + 1) % n) {
            ASSERT_EQ(sides.count({to, from}), 1u) << from << '-' << to;
        }
    }
    EXPECT_NEAR(sum, area_of(ring), 1e-12 * area_of(ring));
}

void expect_swept(const Ring& ring, Touch touch) {
    const auto swept = sweep_touching_polygon(ring, touch);
    ASSERT_TRUE(swept.has_value());
    expect_cover(ring, swept->triangles);
    EXPECT_LT(swept->steps, ring.size() * binary_digits(ring.size()));
}

// A flat base and teeth of random height. One valley touches the base in a corner.
Ring touching_sawtooth(int corners, Random& random) {
    Ring ring{{0, 0}, {1, 0}};
    for (int i = corners - 2; i-- > 0;) {
        ring.push_back({(i + 0.5) / corners, random.uniform(0.01, 1)});
    }
    const auto middle = ring.begin() + corners / 2;
    middle->y = 0.0;
    ring.insert(ring.begin() + 1, Vec2{*middle});
    return ring;
}

// Random points near a diagonal: the triangles of nearly all corners are thin and long.
std::vector<Vec3> thin_tangle(int corners, Random& random) {
    std::vector<Vec3> ring;
    for (int i = 0; i < corners; ++i) {
        const double t = random.uniform(0, 1);
        ring.push_back({t, t + 1e-6 * random.uniform(0, 1), 0});
    }
    return ring;
}

TEST(Orientation, OfCollinearPointsIsDecidedByTheirMotion) {
    const MovingPoint a{{0, 0}, {0, 0}}, b{{1, 1}, {0, 0}};
    EXPECT_EQ(orientation(a, b, {{3, 3}, {0, 1}}), 1);
    EXPECT_EQ(orientation(a, b, {{3, 3}, {1, 0}}), -1);
    EXPECT_EQ(orientation(a, b, {{3, 3}, {1, 1}}), 0);
    EXPECT_EQ(orientation(a, b, {{3, 2}, {0, 9}}), -1) << "the positions decide";
    EXPECT_EQ(orientation({{1, 1}, {0, 0}}, {{1, 1}, {1, 0}}, {{1, 1}, {0, 1}}), 1);
}

TEST(TouchingPolygon, IsSweptInNLogNSteps) {
    Random random(3);
    for (const int corners : {100, 2'000, 50'000}) {
        expect_swept(touching_sawtooth(corners, random), Touch::inside);
        if (HasFailure()) return;
    }
}

TEST(TouchingPolygon, MayTouchItselfInCornersAndAlongSides) {
    {
        SCOPED_TRACE("a corner on a side");
        expect_swept({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, Touch::inside);
    }
    {
        SCOPED_TRACE("a corner that repeats another, and one where the outline turns back");
        expect_swept({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {4, 6}, {4, 4}, {0, 4}}, Touch::outside);
    }
    {
        SCOPED_TRACE("a bridge to a square hole");
        expect_swept(
            {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}},
            Touch::outside);
    }
}

TEST(TouchingPolygon, ThatIsLargeIsCovered) {
    Random random(4);
    const Ring ring = touching_sawtooth(30'000, random);
    std::vector<Vec3> corners;
    for (const Vec2& p : ring) corners.push_back({p, 0.0});
    std::vector<CornerTriangle> triangles;
    EXPECT_TRUE(triangulate(corners, triangles));
    expect_cover(ring, triangles);
}

TEST(CrossingPolygon, ThatIsLargeIsReportedAfterALimitedSearch) {
    Random random(5);
    const std::vector<Vec3> ring = thin_tangle(20'000, random);
    FlatPolygon flat{{}, ring, ring, std::vector<std::uint32_t>(ring.size())};
    for (const Vec3& p : ring) flat.points.emplace_back(p.x, p.y);
    std::iota(flat.order.begin(), flat.order.end(), 0u);
    ASSERT_FALSE(clip_ears(flat, most_ear_steps(ring.size())).has_value()) << "not slow enough";
    std::vector<CornerTriangle> triangles;
    EXPECT_FALSE(triangulate(ring, triangles));
    EXPECT_EQ(triangles.size(), ring.size() - 2);
    const auto unsearched = clip_corners(flat);
    EXPECT_EQ(unsearched.size(), ring.size() - 2);
    for (Vec2& p : flat.points) p = {-p.y, p.x};
    EXPECT_TRUE(clip_corners(flat) == unsearched) << "it depends on the axes";
}

}  // namespace
}  // namespace pectin

// Polygons with many corners and difficult shapes: their triangles cover them exactly, or the
// result reports that they do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "io/obj_reader.h"
#include "mesh/build_mesh.h"
#include "mesh/triangulate.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::Random;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Ring = std::vector<Vec3>;

double area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

double area_of(const Ring& ring) {
    Vec3 sum{0.0};
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        sum += 0.5 * glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    }
    return glm::length(sum);
}

double area_of(const Ring& ring, const Triangles& triangles) {
    double sum = 0.0;
    for (const auto& t : triangles) sum += area(ring[t[0]], ring[t[1]], ring[t[2]]);
    return sum;
}

void expect_covered(const Ring& ring) {
    Triangles triangles;
    EXPECT_TRUE(triangulate(ring, triangles));
    ASSERT_EQ(triangles.size(), ring.size() - 2);
    EXPECT_NEAR(area_of(ring, triangles), area_of(ring), 1e-11 * area_of(ring));
}

// The band between two arms of a spiral.
Ring spiral(int corners, double angle_step, double growth, double width) {
    Ring ring;
    const auto add = [&](int i, double offset) {
        const double a = angle_step * i, r = 0.1 + growth * i + offset;
        ring.push_back({r * std::cos(a), r * std::sin(a), 0});
    };
    for (int i = 0; i < corners / 2; ++i) add(i, 0.0);
    for (int i = corners / 2; i-- > 0;) add(i, width);
    return ring;
}

// A comb with thin teeth, rotated around the origin.
Ring comb(int teeth, double angle) {
    Ring ring;
    const auto add = [&](double x, double y) {
        ring.push_back({x * std::cos(angle) - y * std::sin(angle),
                        x * std::sin(angle) + y * std::cos(angle), 0});
    };
    add(0, -0.1);
    add(1, -0.1);
    for (int i = teeth; i-- > 0;) {
        const double x = static_cast<double>(i) / teeth, gap = 1.0 / teeth;
        add(x + 0.6 * gap, 0);
        add(x + 0.5 * gap, 1);
        add(x + 0.4 * gap, 0);
    }
    return ring;
}

Ring rotated(Ring ring, std::size_t by) {
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(by), ring.end());
    return ring;
}

TEST(LargePolygon, SpiralOfFourThousandCornersIsCoveredExactly) {
    const Ring ring = spiral(4000, 0.05 * std::numbers::pi, 0.0005, 0.002);
    EXPECT_NEAR(area_of(ring), 0.375, 0.01);
    expect_covered(ring);
    expect_covered(rotated(ring, 1234));
}

TEST(LargePolygon, CombsSpiralsAndStarsAreCoveredExactly) {
    expect_covered(spiral(60'000, 0.01 * std::numbers::pi, 0.0005, 0.05));
    for (const double angle : {0.0, std::numbers::pi / 4.0, 1.0}) {
        expect_covered(comb(15'000, angle));
    }
    Random random(9);
    Ring star;
    for (int i = 0; i < 40'000; ++i) {
        const double a = 2.0 * std::numbers::pi * i / 40'000, r = random.uniform(0.1, 1.0);
        star.push_back({r * std::cos(a), 0.3 * r * std::cos(a), r * std::sin(a)});
    }
    expect_covered(star);
}

TEST(LargePolygon, BridgesToHolesAreCoveredExactly) {
    // A plate with a row of square holes. Each is connected to the previous one by a bridge, which
    // the outline follows twice.
    Ring ring{{0, 0, 0}, {100, 0, 0}, {100, 1, 0}, {0, 1, 0}, {0, 0.5, 0}};
    Ring back;
    for (int i = 0; i < 90; ++i) {
        const double x = 1.0 + i;
        ring.push_back({x, 0.5, 0});
        ring.push_back({x + 0.25, 0.75, 0});
        ring.push_back({x + 0.5, 0.5, 0});
        back.push_back({x, 0.5, 0});
        back.push_back({x + 0.25, 0.25, 0});
        back.push_back({x + 0.5, 0.5, 0});
    }
    ring.pop_back();
    ring.insert(ring.end(), back.rbegin(), back.rend());
    ring.push_back({0, 0.5, 0});
    for (std::size_t by = 0; by < ring.size(); by += 37) expect_covered(rotated(ring, by));
}

TEST(LargePolygon, HolesThatTouchTheOutlineAtACornerAreCoveredExactly) {
    // The square and the hole share the corner (0, 0). A bridge joins two other corners of them.
    const Ring one{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {8, 5, 0}, {0, 0, 0},
                   {5, 8, 0}, {8, 5, 0},  {10, 10, 0}, {0, 10, 0}};
    EXPECT_NEAR(area_of(one), 80.5, 1e-12);
    for (std::size_t by = 0; by < one.size(); ++by) expect_covered(rotated(one, by));
    // Several holes of random size touch the same corner. Bridges lead to either of their other
    // corners.
    Random random(15);
    for (int i = 0; i < 300; ++i) {
        const int holes = random.integer(1, 4);
        const double radius = random.uniform(1, 9), step = 0.5 * std::numbers::pi / holes;
        Ring ring{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};
        for (int k = 0; k < holes; ++k) {
            const auto tip = [&](double low, double high) {
                const double a = step * (k + random.uniform(low, high));
                return Vec3{radius * std::cos(a), radius * std::sin(a), 0};
            };
            const Vec3 first = tip(0.1, 0.4), second = tip(0.6, 0.9);
            if (random.chance(0.5)) {
                ring.insert(ring.end(), {first, {0, 0, 0}, second, first, {10, 10, 0}});
            } else {
                ring.insert(ring.end(), {second, first, {0, 0, 0}, second, {10, 10, 0}});
            }
        }
        ring.push_back({0, 10, 0});
        SCOPED_TRACE("case " + std::to_string(i));
        expect_covered(rotated(ring, static_cast<std::size_t>(random.integer(0, 8))));
        if (testing::Test::HasFailure()) return;
    }
}

// The outline of random triangles of a grid. Each triangle is joined to an earlier one along one
// side, so the outline touches itself at corners and along slits.
Ring glued_triangles(Random& random, int size, int triangles) {
    using Corner = std::pair<int, int>;
    std::vector<std::array<Corner, 3>> grid;
    for (int x = 0; x < size; ++x) {
        for (int y = 0; y < size; ++y) {
            const Corner a{x, y}, b{x + 1, y}, c{x + 1, y + 1}, d{x, y + 1};
            const bool joins_a_and_c = random.chance(0.5);
            grid.push_back({a, b, joins_a_and_c ? c : d});
            grid.push_back({joins_a_and_c ? a : b, c, d});
        }
    }
    std::map<std::pair<Corner, Corner>, std::size_t> by_side;
    for (std::size_t t = 0; t < grid.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) by_side[{grid[t][k], grid[t][(k + 1) % 3]}] = t;
    }
    std::vector<bool> is_used(grid.size(), false);
    is_used[0] = true;
    std::vector<Corner> outline(grid[0].begin(), grid[0].end());
    for (int tries = 8 * triangles; tries > 0 && triangles > 1; --tries) {
        const auto i =
            static_cast<std::size_t>(random.integer(0, static_cast<int>(outline.size()) - 1));
        const Corner from = outline[i], to = outline[(i + 1) % outline.size()];
        const auto beyond = by_side.find({to, from});
        if (beyond == by_side.end() || is_used[beyond->second]) continue;
        is_used[beyond->second] = true;
        for (const Corner& tip : grid[beyond->second]) {
            if (tip == from || tip == to) continue;
            outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, tip);
            break;
        }
        --triangles;
    }
    Ring ring;
    for (const auto& [x, y] : outline) ring.push_back({x, y, 0.5 * x - 0.25 * y});
    return ring;
}

TEST(LargePolygon, OutlinesThatTouchThemselvesAnywhereAreCoveredExactly) {
    Random random(16);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        const int size = random.integer(2, 12);
        const Ring ring = glued_triangles(random, size, random.integer(3, 2 * size * size));
        if (ring.size() < 5) continue;
        expect_covered(ring);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(LargePolygon, CornersOnGridsWithManyOnOneLineAreCoveredExactly) {
    // The outline of random columns of unit squares. Most angles are straight or right.
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        Ring ring;
        const int columns = random.integer(3, 30);
        std::vector<int> heights;
        for (int c = 0; c < columns; ++c) heights.push_back(random.integer(1, 4));
        for (int c = 0; c <= columns; ++c) ring.push_back({c, 0, 2.0 * c});
        for (int c = columns; c-- > 0;) {
            const auto h = static_cast<std::size_t>(c);
            for (const int x : {c + 1, c}) ring.push_back({x, heights[h], 2.0 * x});
        }
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        SCOPED_TRACE("case " + std::to_string(i));
        expect_covered(rotated(ring, ring.size() / 3));
        if (testing::Test::HasFailure()) return;
    }
}

TEST(LargePolygon, TrianglesAreMirroredAndDoNotDependOnTheFirstCorner) {
    Random random(12);
    const auto triangles_of = [](const Ring& ring) {
        Triangles triangles;
        triangulate(ring, triangles);
        std::set<std::set<std::pair<double, double>>> result;  // corners by |x| and y
        for (const auto& t : triangles) {
            std::set<std::pair<double, double>> corners;
            for (std::uint32_t c : t) corners.insert({std::abs(ring[c].x), ring[c].y});
            result.insert(corners);
        }
        return result;
    };
    for (int i = 0; i < 300; ++i) {
        const int n = random.integer(5, 30);
        const bool is_regular = random.chance(0.5);
        const Vec3 at{random.uniform(2.5, 5), random.uniform(-3, 3), 0};
        Ring ring;
        for (int k = 0; k < n; ++k) {
            const double a = 2.0 * std::numbers::pi * k / n;
            const double r = is_regular ? 1.0 : random.uniform(0.5, 2.0);
            ring.push_back(at + r * Vec3{std::cos(a), std::sin(a), 0});
        }
        const auto expected = triangles_of(ring);
        ASSERT_EQ(triangles_of(rotated(ring, static_cast<std::size_t>(n / 2))), expected)
            << "case " << i << (is_regular ? ", regular, of " : ", of ") << n;
        for (Vec3& p : ring) p.x = -p.x;
        std::reverse(ring.begin(), ring.end());
        ASSERT_EQ(triangles_of(ring), expected)
            << "case " << i << (is_regular ? ", regular, of " : ", of ") << n;
    }
}

TEST(LargePolygon, WithoutAnInteriorIsReported) {
    Triangles triangles;
    Ring star;
    for (int i = 0; i < 7; ++i) {
        const double a = 2.0 * std::numbers::pi * 3 * i / 7;
        star.push_back({std::cos(a), std::sin(a), 0});
    }
    Ring eight{{0, 0, 0}, {2, 2, 0}, {3, 1, 0}, {2, 0, 0}, {0, 2, 0}, {-1, 1, 0}};
    Random random(3);
    Ring tangle(5'000);
    for (Vec3& p : tangle) p = random.direction();
    EXPECT_FALSE(triangulate(eight, triangles));
    EXPECT_FALSE(triangulate(tangle, triangles));
    EXPECT_EQ(triangles.size(), eight.size() - 2 + tangle.size() - 2);
    // The star winds around its centre three times. It is covered three times, or reported.
    Triangles of_star;
    if (triangulate(star, of_star)) {
        EXPECT_NEAR(area_of(star, of_star), area_of(star), 1e-12);
    }
    Ring line;
    for (int i = 0; i < 50; ++i) line.push_back({0.1 * i, 0.3 * i, 0.7 * i});
    EXPECT_TRUE(triangulate(line, of_star)) << "it has no area to cover";
}

TEST(LargePolygon, IsReportedOnlyIfItIntersectsItself) {
    const std::string corners =
        "v 0 0 0\nv 2 2 0\nv 3 1 0\nv 2 0 0\nv 0 2 0\nv -1 1 0\nv 0 0 5\nv 2 0 5\nv 0 2 5\n";
    const auto report_of = [&](const std::string& faces) {
        return build_mesh(parse_obj(corners + faces, "t.obj")).report;
    };
    EXPECT_EQ(report_of("f 1 2 3 4 5 6\n").crossing_polygons, 1u);
    EXPECT_EQ(report_of("f 1 2 4 5\nf 1 2 3 4 5 6\n").crossing_polygons, 2u);
    EXPECT_EQ(report_of("f 1 4 3 2 5 6\nf 1 4 2 5\nf 7 8 9\n").crossing_polygons, 0u);
}

TEST(LargePolygon, ThatIsFarFromFlatIsReportedThoughItDoesNotCrossItself) {
    // An eight of a small and a large loop, whose sides pass each other at different heights.
    const Ring ring{{0, 0, 0.1}, {4, 4, 0.1}, {7, 2, 0}, {4, 0, -0.1}, {0, 4, -0.1}, {-1, 2, 0}};
    Triangles triangles;
    EXPECT_FALSE(triangulate(ring, triangles));
    EXPECT_EQ(triangles.size(), ring.size() - 2);
}

}  // namespace
}  // namespace pectin

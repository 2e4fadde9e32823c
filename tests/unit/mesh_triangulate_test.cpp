// Tests that the triangles of a polygon have its area together, that none is flipped, and that none
// is missing.
#include "mesh/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/binary_digits.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::Random;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles triangles_of(const std::vector<Vec3>& polygon) {
    Triangles triangles;
    triangulate(polygon, triangles);
    return triangles;
}

Vec3 area_vector(const std::vector<Vec3>& ring) {
    Vec3 sum{0.0};
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        sum += 0.5 * glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    }
    return sum;
}

// Expects n - 2 triangles. Each side of the polygon occurs once, and each diagonal twice, once in
// each direction.
void expect_cover(const std::vector<Vec3>& polygon, const Triangles& triangles) {
    const auto n = static_cast<std::uint32_t>(polygon.size());
    ASSERT_EQ(triangles.size(), n - 2u);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            const auto from = t[static_cast<std::size_t>(i)];
            const auto to = t[static_cast<std::size_t>((i + 1) % 3)];
            ASSERT_LT(from, n);
            if (to == (from + 1) % n) {
                ++sides[{n, from}];
            } else {
                sides[std::minmax(from, to)] += from < to ? 1 : -1;
            }
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) EXPECT_EQ((sides[{n, i}]), 1) << "side " << i;
    for (const auto& [side, count] : sides) {
        if (side.first != n) {
            EXPECT_EQ(count, 0) << side.first << '-' << side.second;
        }
    }
}

void expect_none_flips(const std::vector<Vec3>& polygon, const Triangles& triangles) {
    const Vec3 whole = area_vector(polygon);
    double sum = 0.0;
    for (const auto& t : triangles) {
        const Vec3 part = area_vector({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
        EXPECT_GE(glm::dot(part, whole), -1e-12 * glm::dot(whole, whole));
        sum += glm::length(part);
    }
    EXPECT_NEAR(sum, glm::length(whole), 1e-9 * glm::length(whole));
}

std::vector<Vec3> rotated(std::vector<Vec3> polygon, std::size_t by) {
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(by), polygon.end());
    return polygon;
}

// A polygon around the origin in the plane with this normal. The directions of its corners are
// evenly spaced and have the given radii.
std::vector<Vec3> star_shaped(const Vec3& normal, const std::vector<double>& radii) {
    const Vec3 other = std::abs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = glm::normalize(glm::cross(normal, other)), v = glm::cross(normal, u);
    std::vector<Vec3> ring;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double a =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
        ring.push_back(radii[i] * (std::cos(a) * u + std::sin(a) * v));
    }
    return ring;
}

TEST(Triangulate, LeavesTrianglesAsTheyAre) {
    EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}}));
}

TEST(Triangulate, CoversArrowheads) {
    // The reflex corner is the first, second, third and fourth in turn.
    const std::vector<Vec3> arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
    for (std::size_t by = 0; by < 4; ++by) {
        const auto polygon = rotated(arrow, by);
        expect_cover(polygon, triangles_of(polygon));
        expect_none_flips(polygon, triangles_of(polygon));
    }
}

TEST(Triangulate, GivesNoCornerOfARegularPolygonManyTriangles) {
    for (std::size_t n : {5u, 6u, 9u, 40u, 4096u}) {
        const auto polygon = star_shaped({0.36, 0.48, 0.8}, std::vector<double>(n, 2.0));
        const Triangles triangles = triangles_of(polygon);
        expect_cover(polygon, triangles);
        expect_none_flips(polygon, triangles);
        std::vector<std::size_t> uses(n, 0);
        for (const auto& t : triangles) {
            for (std::uint32_t corner : t) ++uses[corner];
        }
        EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 2 * binary_digits(n)) << n;
    }
}

TEST(Triangulate, CoversConcavePolygonsWithoutFlips) {
    Random random(50);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        std::vector<double> radii(static_cast<std::size_t>(random.integer(4, 24)));
        for (double& r : radii) r = random.uniform(0.1, 2.0);
        const auto polygon = star_shaped(random.direction(), radii);
        if (radii.size() == 4 && glm::length(area_vector(polygon)) < 0.1) continue;
        const Triangles triangles = triangles_of(polygon);
        expect_cover(polygon, triangles);
        expect_none_flips(polygon, triangles);
        if (HasFailure()) return;
    }
}

TEST(Triangulate, CoversCombsAndSpiralsWithoutFlips) {
    std::vector<Vec3> comb;  // its teeth are a tenth as wide as the gaps
    for (int i = 0; i < 6; ++i) {
        comb.push_back({i, 0.1, 0});
        comb.push_back({i + 0.05, 3, 0});
        comb.push_back({i + 0.1, 0.1, 0});
    }
    comb.push_back({6, 0, 0});
    comb.push_back({0, 0, 0});
    std::reverse(comb.begin(), comb.end());
    std::vector<Vec3> spiral;
    for (int i = 0; i <= 40; ++i) {
        const double a = 0.4 * i;
        spiral.push_back({(1 + 0.2 * a) * std::cos(a), (1 + 0.2 * a) * std::sin(a), 0});
    }
    for (int i = 40; i >= 0; --i) {
        const double a = 0.4 * i;
        spiral.push_back({(0.8 + 0.2 * a) * std::cos(a), (0.8 + 0.2 * a) * std::sin(a), 0});
    }
    for (const auto& polygon : {comb, spiral}) {
        for (std::size_t by = 0; by < polygon.size(); by += 3) {
            const auto ring = rotated(polygon, by);
            expect_cover(ring, triangles_of(ring));
            expect_none_flips(ring, triangles_of(ring));
        }
    }
}

TEST(Triangulate, CoversPolygonsWithCollinearCorners) {
    // A square whose sides are divided, as some modelling programs write it.
    std::vector<Vec3> ring;
    const Vec3 corners[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < 4; ++i) {
            ring.push_back(corners[side] + i / 4.0 * (corners[(side + 1) % 4] - corners[side]));
        }
    }
    for (std::size_t by = 0; by < ring.size(); ++by) {
        const auto polygon = rotated(ring, by);
        expect_cover(polygon, triangles_of(polygon));
        expect_none_flips(polygon, triangles_of(polygon));
    }
}

TEST(Triangulate, GivesPolygonsWithoutInteriorTheSameNumberOfTriangles) {
    // A bow tie, a star that intersects itself, and a polygon whose corners coincide.
    const std::vector<Vec3> tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(triangles_of(tie).size(), 2u);
    const auto pentagon = star_shaped({0, 0, 1}, std::vector<double>(5, 1.0));
    const std::vector<Vec3> star{pentagon[0], pentagon[2], pentagon[4], pentagon[1], pentagon[3]};
    expect_cover(star, triangles_of(star));
    const std::vector<Vec3> point(7, Vec3{1.0});
    expect_cover(point, triangles_of(point));
}

// Each polygon would take minutes if every ear were compared with every corner.
TEST(Triangulate, HandlesLargePolygons) {
    Random random(77);
    std::vector<double> radii(20'000);
    for (double& r : radii) r = random.uniform(0.5, 1.0);
    const auto star = star_shaped({0, 0, 1}, radii);
    const Triangles of_star = triangles_of(star);
    expect_cover(star, of_star);
    expect_none_flips(star, of_star);
    std::vector<Vec3> tangle(20'000);
    for (Vec3& p : tangle) p = random.direction();
    EXPECT_EQ(triangles_of(tangle).size(), tangle.size() - 2);
    std::vector<Vec3> huge = star;
    for (Vec3& p : huge) p *= 1e307;
    EXPECT_EQ(triangles_of(huge).size(), huge.size() - 2);
}

TEST(Triangulate, AppendsToTheGivenTriangles) {
    Triangles triangles{{7, 8, 9}};
    triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, triangles);
    EXPECT_EQ(triangles, (Triangles{{7, 8, 9}, {0, 1, 2}}));
}

}  // namespace
}  // namespace pectin

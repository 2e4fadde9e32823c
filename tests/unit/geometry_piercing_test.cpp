// Segments and triangles: known cases, and random ones compared with sampling.
#include "geometry/piercing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_mesh.h"

namespace pectin {
namespace {

const Vec3 kA{0, 0, 0}, kB{1, 0, 0}, kC{0, 1, 0};

TEST(Pierces, NeedsBothEndsBeyondThePlaneAndTheLineInside) {
    EXPECT_TRUE(pierces({0.2, 0.2, 1}, {0.2, 0.2, -1}, kA, kB, kC));
    EXPECT_TRUE(pierces({0.2, 0.2, -1}, {0.2, 0.2, 1}, kA, kB, kC));
    EXPECT_FALSE(pierces({0.2, 0.2, 1}, {0.2, 0.2, 0.5}, kA, kB, kC));
    EXPECT_FALSE(pierces({0.8, 0.8, 1}, {0.8, 0.8, -1}, kA, kB, kC));
    EXPECT_FALSE(pierces({0.2, 0.2, 1}, {0.2, 0.2, 0}, kA, kB, kC));   // ends in it
    EXPECT_FALSE(pierces({0.5, 0, 1}, {0.5, 0, -1}, kA, kB, kC));      // goes through an edge
    EXPECT_FALSE(pierces({-1, 0.2, 0}, {1, 0.2, 0}, kA, kB, kC));      // lies in its plane
    EXPECT_FALSE(pierces({0.2, 0.2, 1}, {0.2, 0.2, -1}, kA, kB, kB));  // no area
    EXPECT_TRUE(pierces({2e-100, 2e-100, 1e-100}, {2e-100, 2e-100, -1e-100}, kA, kB, kC));
}

Vec3 somewhere(test::Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(Pierces, IsWhereTheDistanceIsZero) {
    test::Random random(7301);
    int through = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p = somewhere(random), q = somewhere(random), a = somewhere(random),
                   b = somewhere(random), c = somewhere(random);
        const bool is_through = pierces(p, q, a, b, c);
        through += is_through ? 1 : 0;
        ASSERT_EQ(is_through, squared_distance(p, q, a, b, c) == 0.0) << "seed 7301, case " << i;
    }
    EXPECT_GT(through, 1000);
}

TEST(SquaredDistance, OfSegmentsIsTheLeastOfAnyTwoOfTheirPoints) {
    test::Random random(7302);
    for (int i = 0; i < 300; ++i) {
        const Vec3 p = somewhere(random), r = somewhere(random);
        const Vec3 q = random.chance(0.1) ? p : somewhere(random);
        const Vec3 s = random.chance(0.1)   ? r
                       : random.chance(0.2) ? r + random.uniform(-2, 2) * (q - p)  // parallel
                                            : somewhere(random);
        const double found = std::sqrt(squared_distance(p, q, r, s));
        double least = 1e9;
        for (int j = 0; j <= 60; ++j) {
            for (int k = 0; k <= 60; ++k) {
                least = std::min(least,
                                 glm::distance(glm::mix(p, q, j / 60.0), glm::mix(r, s, k / 60.0)));
            }
        }
        EXPECT_LE(found, least + 1e-12) << "seed 7302, case " << i;
        // No point of either is farther than half a step from a sample.
        EXPECT_GE(found, least - (glm::distance(p, q) + glm::distance(r, s)) / 120.0 - 1e-12)
            << "seed 7302, case " << i;
    }
}

TEST(SquaredDistance, OfASegmentAndATriangleIsTheLeastOfAnyTwoOfTheirPoints) {
    test::Random random(7303);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = somewhere(random), q = somewhere(random), a = somewhere(random),
                   b = somewhere(random), c = somewhere(random);
        const double found = std::sqrt(squared_distance(p, q, a, b, c));
        double least = 1e9;
        for (int j = 0; j <= 40; ++j) {
            for (int k = 0; k <= 40; ++k) {
                for (int l = 0; k + l <= 40; ++l) {
                    const Vec3 at = a + k / 40.0 * (b - a) + l / 40.0 * (c - a);
                    least = std::min(least, glm::distance(glm::mix(p, q, j / 40.0), at));
                }
            }
        }
        EXPECT_LE(found, least + 1e-12) << "seed 7303, case " << i;
        EXPECT_GE(found, least - 0.2) << "seed 7303, case " << i;
    }
}

}  // namespace
}  // namespace pectin

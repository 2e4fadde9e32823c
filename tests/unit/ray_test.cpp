#include "geometry/ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace pectin {
namespace {

const Vec3 kA{0, 0, 0}, kB{2, 0, 0}, kC{0, 2, 0};  // counter-clockwise seen from +z

TEST(RayTriangle, FindsThePointAndItsBarycentricCoordinates) {
    const auto hit = intersect(Ray{.origin = Vec3(0.5, 0.25, 3)}, kA, kB, kC);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 3.0, 1e-15);
    EXPECT_NEAR(hit->v, 0.25, 1e-15);
    EXPECT_NEAR(hit->w, 0.125, 1e-15);
    EXPECT_NEAR(hit->u + hit->v + hit->w, 1.0, 1e-15);
}

TEST(RayTriangle, DistinguishesTheFrontFromTheBack) {
    for (const Vec3& from : {Vec3(0.5, 0.5, 3), Vec3(-2, 0.4, 1), Vec3(0.3, -3, 0.5)}) {
        const Ray ahead{from, Vec3(0.5, 0.5, 0) - from};
        const Vec3 below{from.x, from.y, -from.z};
        const Ray behind{below, Vec3(0.5, 0.5, 0) - below};
        ASSERT_TRUE(intersect(ahead, kA, kB, kC) && intersect(behind, kA, kB, kC));
        EXPECT_TRUE(intersect(ahead, kA, kB, kC)->from_outside);
        EXPECT_FALSE(intersect(behind, kA, kB, kC)->from_outside);
        EXPECT_FALSE(intersect(ahead, kA, kC, kB)->from_outside);
    }
}

TEST(RayTriangle, IsNotHitBehindTheOriginBesideItOrEdgeOn) {
    EXPECT_FALSE(intersect(Ray{.origin = Vec3(0.5, 0.5, -1)}, kA, kB, kC));
    EXPECT_FALSE(intersect(Ray{.origin = Vec3(1.5, 1.5, 1)}, kA, kB, kC));
    EXPECT_FALSE(intersect(Ray{Vec3(-1, 0.5, 0), Vec3(1, 0, 0)}, kA, kB, kC));
    EXPECT_FALSE(intersect(Ray{.origin = Vec3(0.5, 0, 1)}, kA, kB, 0.5 * (kA + kB)));
}

TEST(RayTriangle, AgreesWithThePointItWasAimedAt) {
    std::mt19937 bits(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3{unit(bits), unit(bits), unit(bits)}; };
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 a = vector(), b = vector(), c = vector(), origin = 3.0 * vector();
        const Vec3 aim = (a + b + c) / 3.0;
        const auto hit = intersect(Ray{origin, aim - origin}, a, b, c);
        if (!hit) continue;  // edge-on, because of rounding
        EXPECT_NEAR(hit->t, 1.0, 1e-6);
        const double facing = glm::dot(glm::cross(b - a, c - a), origin - aim);
        if (std::abs(facing) > 1e-9) {
            EXPECT_EQ(hit->from_outside, facing > 0.0);
        }
    }
}

// Rays through the edges and the centre of a fan must not pass between its triangles.
TEST(RayTriangle, HitsSharedEdgesAndVerticesWithEveryRay) {
    std::mt19937 bits(6);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3{unit(bits), unit(bits), unit(bits)}; };
    for (int i = 0; i < 2'000; ++i) {
        const Vec3 middle = 0.1 * vector();
        std::vector<Vec3> rim;
        for (int k = 0; k < 7; ++k)
            rim.push_back({std::cos(0.9 * k), std::sin(0.9 * k), 0.3 * unit(bits)});
        const Vec3 origin = Vec3(0, 0, 4) + vector();
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const double along = i % 5 == 0 ? 0.0 : 0.5 + 0.49 * unit(bits);
            const Ray ray{origin, middle + along * (rim[k] - middle) - origin};
            int met = 0;
            for (std::size_t t = 0; t < rim.size(); ++t)
                met += intersect(ray, middle, rim[t], rim[(t + 1) % rim.size()]).has_value();
            EXPECT_GE(met, 1);
        }
    }
}

TEST(RayBox, ReturnsTheIntervalInside) {
    const Box box{.min = Vec3(-1), .max = Vec3(1)};
    const auto through = intersect(Ray{Vec3(0, 0, 5), Vec3(0, 0, -2)}, box);
    ASSERT_TRUE(through);
    EXPECT_NEAR(through->enter, 2.0, 1e-12);
    EXPECT_NEAR(through->leave, 3.0, 1e-12);
    const auto from_inside = intersect(Ray{Vec3(0), Vec3(1, 1, 0)}, box);
    ASSERT_TRUE(from_inside);
    EXPECT_EQ(from_inside->enter, 0.0);
    EXPECT_NEAR(from_inside->leave, 1.0, 1e-12);
}

TEST(RayBox, IsMissedBesideItAndBehindTheOrigin) {
    const Box box{.min = Vec3(-1), .max = Vec3(1)};
    EXPECT_FALSE(intersect(Ray{Vec3(0, 1.5, 5), Vec3(0, 0, -1)}, box));
    EXPECT_FALSE(intersect(Ray{Vec3(0, 0, 5), Vec3(0, 0, 1)}, box));
    EXPECT_FALSE(intersect(Ray{Vec3(-5, 0, 0), Vec3(1, 1, 0)}, box));
    EXPECT_FALSE(intersect(Ray{Vec3(0), Vec3(1, 0, 0)}, Box{}));
}

TEST(RayBox, IsHitByEveryRayThatHitsATriangleInIt) {
    std::mt19937 bits(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vec3{unit(bits), unit(bits), unit(bits)}; };
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 a = vector(), b = vector(), origin = 3.0 * vector();
        Vec3 c = vector();
        c.z = b.z;
        Box box;
        for (const Vec3& p : {a, b, c}) box.include(p);
        // The ray passes through an edge in a face of the box, or through a corner.
        const Ray ray{origin, (i % 2 == 0 ? 0.5 * (b + c) : a) - origin};
        const auto hit = intersect(ray, a, b, c);
        if (!hit) continue;
        const auto stretch = intersect(ray, box);
        ASSERT_TRUE(stretch);
        EXPECT_LE(stretch->enter, hit->t * (1.0 + 1e-12));
        EXPECT_GE(stretch->leave, hit->t * (1.0 - 1e-12));
    }
}

}  // namespace
}  // namespace pectin

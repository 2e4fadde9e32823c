// The test of a triangle against a box, compared with clipping.
#include "geometry/box.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::Random;
using Triangle = std::array<Vec3, 3>;

bool meets(const Triangle& t, const Box& box) { return triangle_meets_box(t[0], t[1], t[2], box); }

// Whether anything of the triangle remains after clipping it by the six planes of the box.
// Source: I. E. Sutherland, G. W. Hodgman. Reentrant Polygon Clipping. Communications of the ACM
// 17(1), 1974.
bool leaves_something_when_clipped(const Triangle& t, const Box& box) {
    std::vector<Vec3> polygon(t.begin(), t.end());
    for (int axis = 0; axis < 3; ++axis) {
        for (double sign : {1.0, -1.0}) {
            const double limit = sign > 0.0 ? box.max[axis] : -box.min[axis];
            std::vector<Vec3> kept;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
                const double dp = limit - sign * p[axis], dq = limit - sign * q[axis];
                if (dp >= 0.0) kept.push_back(p);
                if ((dp < 0.0) != (dq < 0.0)) kept.push_back(p + dp / (dp - dq) * (q - p));
            }
            polygon = kept;
        }
    }
    return !polygon.empty();
}

Box random_box(Random& random) {
    Box box;
    for (int i = 0; i < 2; ++i) {
        box.include({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    }
    return box;
}

// Large, small and thin triangles, and some without area.
Triangle random_triangle(Random& random) {
    const Vec3 centre = random.uniform(0.0, 2.0) * random.direction();
    const double size = random.scale(0.05, 20.0);
    Triangle t;
    for (Vec3& p : t) p = centre + random.uniform(0.0, size) * random.direction();
    if (random.chance(0.1)) t[2] = 0.3 * t[0] + 0.7 * t[1];
    if (random.chance(0.05)) t[2] = t[1];
    if (random.chance(0.1)) t[1].y = t[0].y = t[2].y;
    return t;
}

Box grown(const Box& box, double by) { return {.min = box.min - by, .max = box.max + by}; }

TEST(TriangleMeetsBox, AgreesWithClippingUpToRounding) {
    constexpr double kBand = 1e-9;
    Random random(20);
    int met = 0, missed = 0;
    for (int i = 0; i < 40000; ++i) {
        const Box box = random_box(random);
        const Triangle t = random_triangle(random);
        if (glm::length(box.extent()) < 0.1) continue;
        if (leaves_something_when_clipped(t, grown(box, -kBand))) {
            ++met;
            EXPECT_TRUE(meets(t, box)) << "case " << i;
        } else if (!leaves_something_when_clipped(t, grown(box, kBand))) {
            ++missed;
            EXPECT_FALSE(meets(t, box)) << "case " << i;
        }
    }
    EXPECT_GT(met, 2000);
    EXPECT_GT(missed, 2000);
}

TEST(TriangleMeetsBox, FindsEveryTriangleWithASampledPointInside) {
    Random random(21);
    for (int i = 0; i < 2000; ++i) {
        const Box box = random_box(random);
        const Triangle t = random_triangle(random);
        bool inside = false;
        for (int u = 0; u <= 20; ++u) {
            for (int v = 0; u + v <= 20; ++v) {
                const Vec3 p = t[0] + u / 20.0 * (t[1] - t[0]) + v / 20.0 * (t[2] - t[0]);
                inside = inside || box.contains_strictly(p);
            }
        }
        EXPECT_TRUE(!inside || meets(t, box)) << "case " << i;
    }
}

TEST(TriangleMeetsBox, DoesNotDependOnTheFirstCorner) {
    Random random(22);
    int near = 0;
    for (int i = 0; i < 40000; ++i) {
        const Box box = random_box(random);
        Triangle t = random_triangle(random);
        if (i % 2 == 0) {  // in a plane through a corner of the box: rounding decides
            const Vec3 n = random.direction();
            for (Vec3& p : t) p -= glm::dot(p - box.max, n) * n;
            ++near;
        }
        const bool answer = meets(t, box);
        EXPECT_EQ(meets({t[1], t[2], t[0]}, box), answer) << "case " << i;
        EXPECT_EQ(meets({t[2], t[0], t[1]}, box), answer) << "case " << i;
    }
    EXPECT_GT(near, 0);
}

TEST(TriangleMeetsBox, CountsTouchingAsMeeting) {
    const Box unit{.min = Vec3{0.0}, .max = Vec3{1.0}};
    EXPECT_TRUE(meets({Vec3{1, 1, 1}, Vec3{2, 1, 1}, Vec3{1, 2, 1}}, unit));    // a corner
    EXPECT_TRUE(meets({Vec3{1, -1, 2}, Vec3{1, 2, -1}, Vec3{3, 2, 2}}, unit));  // its side x = 1
    EXPECT_TRUE(meets({Vec3{2, 0, 0.5}, Vec3{0, 2, 0.5}, Vec3{2, 2, 0.5}}, unit));  // an edge
    EXPECT_FALSE(meets({Vec3{2.01, 0, 0.5}, Vec3{0.01, 2, 0.5}, Vec3{2, 2, 0.5}}, unit));
    EXPECT_FALSE(meets({Vec3{1.01, 0, 0}, Vec3{2, 1, 1}, Vec3{2, 0, 0}}, unit));
}

TEST(TriangleMeetsBox, FindsATriangleAroundTheBoxAndOneInsideIt) {
    const Box unit{.min = Vec3{0.0}, .max = Vec3{1.0}};
    EXPECT_TRUE(meets({Vec3{-9, -9, 0.5}, Vec3{9, -9, 0.5}, Vec3{0.5, 20, 0.5}}, unit));
    EXPECT_TRUE(meets({Vec3{0.4, 0.4, 0.4}, Vec3{0.6, 0.4, 0.4}, Vec3{0.4, 0.6, 0.4}}, unit));
    // The bounds of the triangle contain the box, and its plane misses the box.
    EXPECT_FALSE(meets({Vec3{4, 0, 0}, Vec3{0, 4, 0}, Vec3{0, 0, 4}}, unit));
    EXPECT_TRUE(meets({Vec3{3, 0, 0}, Vec3{0, 3, 0}, Vec3{0, 0, 3}}, unit));
    // Only the cross product of two edges separates them.
    EXPECT_FALSE(meets({Vec3{1.5, -0.2, 0.5}, Vec3{0.5, -0.8, 0.5}, Vec3{1.5, -0.8, 0.6}}, unit));
}

TEST(TriangleMeetsBox, IsFalseForAnEmptyBox) {
    EXPECT_FALSE(meets({Vec3{0.0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}, Box{}));
}

TEST(Box, GrowsByWhatItIncludes) {
    Box box;
    EXPECT_TRUE(box.is_empty());
    EXPECT_EQ(box.extent(), Vec3{0.0});
    EXPECT_EQ(box.diagonal(), 0.0);
    box.include(Vec3{1, 2, 3});
    EXPECT_FALSE(box.is_empty());
    EXPECT_EQ(box.extent(), Vec3{0.0});
    box.include(Vec3{-1, 2, 5});
    EXPECT_EQ(box.centre(), Vec3(0, 2, 4));
    EXPECT_EQ(box.extent(), Vec3(2, 0, 2));
    Box other = box;
    other.include(Box{});
    EXPECT_EQ(other, box);
}

TEST(Box, IsClosedButContainsStrictlyOnlyItsInside) {
    const Box unit{.min = Vec3{0.0}, .max = Vec3{1.0}};
    EXPECT_TRUE(unit.contains_strictly({0.5, 0.5, 0.5}));
    for (int axis = 0; axis < 3; ++axis) {
        for (double side : {0.0, 1.0}) {
            Vec3 p{0.5};
            p[axis] = side;
            EXPECT_FALSE(unit.contains_strictly(p));
            EXPECT_TRUE(unit.meets({.min = p, .max = p}));
            EXPECT_TRUE(unit.contains({.min = p, .max = p}));
            p[axis] = side == 0.0 ? -1e-9 : 1.0 + 1e-9;
            EXPECT_FALSE(unit.meets({.min = p, .max = p}));
            EXPECT_FALSE(unit.contains({.min = p, .max = p}));
        }
    }
}

}  // namespace
}  // namespace pectin

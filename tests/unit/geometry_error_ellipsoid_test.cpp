// Error ellipsoids contain what they are said to contain, and keep their bytes where they must.
#include "geometry/error_ellipsoid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "support/random_ellipsoid.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

constexpr int kMembers = 30;

// Calls test(random, size) for each case. Sizes are those of models of any unit.
template <typename Test>
void for_each_case(const Test& test) {
    for (int i = 0; i < test::case_count(300); ++i) {
        const std::uint64_t seed = 100 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        test(random, random.scale(1e-12, 1e6));
        if (testing::Test::HasFailure()) return;
    }
}

Mat3 random_jacobian(Random& random) {
    const auto column = [&] { return random.scale(1e-6, 3.0) * random.direction(); };
    return {column(), column(), column()};
}

TEST(ErrorEllipsoid, HoldsABallOrASegmentAndHasItsRadius) {
    for_each_case([](Random& random, double size) {
        const Vec3 v = size * random.direction();
        const ErrorEllipsoid segment = ErrorEllipsoid::segment(v),
                             ball = ErrorEllipsoid::ball(size);
        EXPECT_TRUE(test::contains(segment, v));
        EXPECT_FALSE(test::contains(segment, 1.01 * v));
        EXPECT_TRUE(test::contains(ball, v));
        EXPECT_FALSE(test::contains(ball, 1.01 * v));
        for (const ErrorEllipsoid& e : {segment, ball}) {
            EXPECT_GE(e.radius(), size * (1.0 - 1e-12));
            EXPECT_LE(e.radius(), size * (1.0 + 1e-6));
            EXPECT_GE(e.rough_radius(), e.radius());
        }
        const Vec3 across = glm::cross(v, random.direction());
        EXPECT_FALSE(test::contains(segment, 1e-3 * size * unit_or_zero(across)));
    });
}

TEST(ErrorEllipsoid, HasTheRadiusOfItsFarthestMember) {
    for_each_case([](Random& random, double size) {
        const ErrorEllipsoid e = test::random_ellipsoid(random, size);
        double farthest = 0.0;
        for (int i = 0; i < 300; ++i) {
            farthest = std::max(farthest, glm::length(test::random_member(e, random)));
        }
        EXPECT_GE(e.radius(), farthest);
        EXPECT_GE(e.rough_radius(), e.radius());
        EXPECT_LE(e.rough_radius(), e.radius() * 1.7321);
        // The farthest member is where power iteration goes.
        Vec3 axis = random.direction();
        for (int i = 0; i < 3000; ++i) axis = glm::normalize(e.matrix() * axis);
        EXPECT_NEAR(e.radius(), std::sqrt(glm::dot(axis, e.matrix() * axis)), 1e-3 * e.radius());
    });
}

TEST(ErrorEllipsoid, OfASumContainsTheSumsOfMembers) {
    for_each_case([](Random& random, double size) {
        const ErrorEllipsoid a = test::random_ellipsoid(random, size),
                             b = test::random_ellipsoid(random, size * random.scale(1e-6, 1.0)),
                             sum = ErrorEllipsoid::sum(a, b);
        EXPECT_EQ(sum, ErrorEllipsoid::sum(b, a));
        for (int i = 0; i < kMembers; ++i) {
            const Vec3 u = test::random_member(a, random), v = test::random_member(b, random);
            ASSERT_TRUE(test::contains(sum, u + v));
        }
        EXPECT_LE(sum.radius(), 1.0001 * (a.rough_radius() + b.rough_radius()));
    });
}

TEST(ErrorEllipsoid, OfAnImageContainsTheImagesOfMembers) {
    for_each_case([](Random& random, double size) {
        const ErrorEllipsoid a = test::random_ellipsoid(random, size);
        const Mat3 jacobian = random_jacobian(random);
        const ErrorEllipsoid image = ErrorEllipsoid::image(jacobian, a);
        for (int i = 0; i < kMembers; ++i) {
            ASSERT_TRUE(test::contains(image, jacobian * test::random_member(a, random)));
        }
    });
}

TEST(ErrorEllipsoid, OfAHullContainsTheMembersOfBoth) {
    for_each_case([](Random& random, double size) {
        const ErrorEllipsoid a = test::random_ellipsoid(random, size),
                             b = test::random_ellipsoid(random, size * random.scale(1e-2, 1.0)),
                             hull = ErrorEllipsoid::hull(a, b);
        EXPECT_EQ(hull, ErrorEllipsoid::hull(b, a));
        for (int i = 0; i < kMembers; ++i) {
            ASSERT_TRUE(test::contains(hull, test::random_member(a, random)));
            ASSERT_TRUE(test::contains(hull, test::random_member(b, random)));
        }
        EXPECT_LE(hull.radius(), 1.415 * std::max(a.radius(), b.radius()));
    });
}

// With symmetry, mirrored faces must have mirrored errors to the byte.
TEST(ErrorEllipsoid, OfMirroredVectorsIsTheMirrorImage) {
    for_each_case([](Random& random, double size) {
        const auto axis = static_cast<std::size_t>(random.integer(0, 2));
        const auto mirrored = [&](Vec3 v) {
            v[static_cast<int>(axis)] = -v[static_cast<int>(axis)];
            return v;
        };
        const auto hull_of = [](const std::array<Vec3, 4>& v) {
            const auto sum = [](const Vec3& u, const Vec3& w) {
                return ErrorEllipsoid::sum(ErrorEllipsoid::segment(u), ErrorEllipsoid::segment(w));
            };
            return ErrorEllipsoid::hull(sum(v[0], v[1]), sum(v[2], v[3]));
        };
        std::array<Vec3, 4> vectors, images;
        for (std::size_t i = 0; i < vectors.size(); ++i) {
            vectors[i] = size * random.scale(1e-2, 1.0) * random.direction();
            images[i] = mirrored(vectors[i]);
        }
        const ErrorEllipsoid hull = hull_of(vectors), image = hull_of(images);
        EXPECT_EQ(hull.radius(), image.radius());
        // The entries xx, yy and zz, and then xy, xz and yz, whose sign changes with one axis.
        std::array<float, 6> expected = hull.entries();
        for (std::size_t entry = 3; entry < 6; ++entry) {
            if (entry != 5 - axis) expected[entry] = -expected[entry];
        }
        EXPECT_EQ(image.entries(), expected);
    });
}

// What is merged exactly, and undone, must not change.
TEST(ErrorEllipsoid, KeepsItsBytesInAHullWithWhatLiesInIt) {
    for_each_case([](Random& random, double size) {
        const ErrorEllipsoid a = test::random_ellipsoid(random, size);
        EXPECT_EQ(ErrorEllipsoid::hull(a, a), a);
        EXPECT_EQ(ErrorEllipsoid::hull(a, {}), a);
        EXPECT_EQ(ErrorEllipsoid::sum(a, {}), a);
        const ErrorEllipsoid part = ErrorEllipsoid::image(Mat3{random.uniform(0.0, 0.6)}, a);
        EXPECT_EQ(ErrorEllipsoid::hull(a, part), a);
        EXPECT_EQ(ErrorEllipsoid::hull(part, a), a);
    });
}

TEST(ErrorEllipsoid, IsZeroOnlyIfNothingWasAdded) {
    const Vec3 tiny{1e-170, 0.0, 0.0};
    EXPECT_EQ(ErrorEllipsoid::segment(Vec3{0.0}), ErrorEllipsoid{});
    EXPECT_EQ(ErrorEllipsoid::ball(0.0), ErrorEllipsoid{});
    EXPECT_EQ(ErrorEllipsoid{}.radius(), 0.0);
    EXPECT_EQ(ErrorEllipsoid::image(Mat3{2.0}, {}), ErrorEllipsoid{});
    for (const ErrorEllipsoid& e : {ErrorEllipsoid::segment(tiny), ErrorEllipsoid::ball(tiny.x)}) {
        EXPECT_FALSE(e.is_zero());
        EXPECT_GE(e.radius(), tiny.x);
    }
}

TEST(ErrorEllipsoid, IsAllOfSpaceIfItIsTooLarge) {
    const ErrorEllipsoid one = ErrorEllipsoid::ball(1.0);
    const double infinite = std::numeric_limits<double>::infinity();
    for (double radius : {1e30, infinite, std::numeric_limits<double>::quiet_NaN()}) {
        const ErrorEllipsoid all = ErrorEllipsoid::ball(radius);
        EXPECT_EQ(all.radius(), infinite);
        EXPECT_EQ(ErrorEllipsoid::sum(all, one), all);
        EXPECT_EQ(ErrorEllipsoid::hull(one, all), all);
        EXPECT_EQ(ErrorEllipsoid::image(Mat3{0.0}, all), all);
    }
    EXPECT_EQ(ErrorEllipsoid::image(Mat3{1e30}, one).radius(), infinite);
}

}  // namespace
}  // namespace pectin

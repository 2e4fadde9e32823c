// Bounds of second derivatives that differ by direction, on random coefficients and triangles.
//
// Sources: E. F. D'Azevedo, R. B. Simpson. On Optimal Interpolation Triangle Incidences. SIAM
// Journal on Scientific and Statistical Computing 10(6), 1989. J. R. Shewchuk. What Is a Good
// Linear Element? Interpolation, Conditioning, and Quality Measures. 11th International Meshing
// Roundtable, 2002.
#include "ffd/plane_bend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

Vec2 direction_at(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Some are degenerate: they do not measure along one direction.
PlaneForm random_form(Random& random) {
    const Vec2 axis = direction_at(random.uniform(0.0, std::numbers::pi));
    const double along = random.scale(1e-3, 1e3),
                 across = random.chance(0.3) ? 0.0 : along * random.scale(1e-6, 1.0);
    return {along * axis.x * axis.x + across * axis.y * axis.y, (along - across) * axis.x * axis.y,
            along * axis.y * axis.y + across * axis.x * axis.x};
}

// Some are needles, and some have a right angle.
PlaneSides random_sides(Random& random) {
    const double size = random.scale(1e-3, 1e3);
    const Vec2 first = size * direction_at(random.uniform(0.0, 2.0 * std::numbers::pi));
    const Vec2 across{-first.y, first.x};
    const double height = random.chance(0.3) ? random.scale(1e-9, 1.0) : random.uniform(0.0, 1.5);
    const double along = random.chance(0.2) ? 0.0 : random.uniform(-0.5, 1.5);
    const Vec2 second = along * first + height * across;
    return {first, second - first, -second};
}

TEST(PlaneForm, SquareRootTwiceIsTheForm) {
    const int cases = test::case_count(1000);
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = 12000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const PlaneForm q = random_form(random), root = square_root(q);
        const double largest = q.xx + q.yy;
        ASSERT_NEAR(root.xx * root.xx + root.xy * root.xy, q.xx, 1e-7 * largest);
        ASSERT_NEAR(root.xy * (root.xx + root.yy), q.xy, 1e-7 * largest);
        ASSERT_NEAR(root.yy * root.yy + root.xy * root.xy, q.yy, 1e-7 * largest);
    }
    EXPECT_EQ(square_root(PlaneForm{}).xx, 0.0);
}

// The interpolation error of the function ½ q at a point with barycentric coordinates λ is half the
// sum of λ_i λ_j q(side between i and j). Its greatest value is ½ R².
TEST(PlaneForm, EnclosingRadiusIsTheGreatestInterpolationErrorOfTheForm) {
    const int cases = test::case_count(300);
    constexpr int kSamples = 60;
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = 13000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const PlaneForm q = random_form(random);
        const PlaneSides sides = random_sides(random);
        double greatest = 0.0;
        for (int a = 0; a <= kSamples; ++a) {
            for (int b = 0; a + b <= kSamples; ++b) {
                const double x = 1.0 * a / kSamples, y = 1.0 * b / kSamples, z = 1.0 - x - y;
                greatest = std::max(
                    greatest, x * y * q(sides[0]) + y * z * q(sides[1]) + z * x * q(sides[2]));
            }
        }
        const double squared_radius = squared_enclosing_radius(q, sides);
        ASSERT_GE(squared_radius, greatest);
        ASSERT_LE(squared_radius, 1.002 * greatest);
    }
}

template <typename T>
T random_value(Random& random) {
    if constexpr (std::is_same_v<T, double>) {
        return random.uniform(-1.0, 1.0);
    } else {
        return random.uniform(0.0, 1.0) * random.direction();
    }
}

template <typename T>
using Second = std::array<derivative_norms::Cube<T>, 6>;

// Coefficients around a common form, as of a small region, or anywhere.
template <typename T>
Second<T> random_coefficients(Random& random, const std::array<T, 6>& around, double deviation) {
    Second<T> second;
    for (std::size_t e = 0; e < 6; ++e) {
        for (T& value : second[e]) value = around[e] + deviation * random_value<T>(random);
    }
    return second;
}

template <typename T>
double bend_along(const Second<T>& second, std::size_t i, const Vec3& u) {
    const T sum = u.x * u.x * second[0][i] + u.y * u.y * second[1][i] + u.z * u.z * second[2][i] +
                  2.0 * u.x * u.y * second[3][i] + 2.0 * u.y * u.z * second[4][i] +
                  2.0 * u.z * u.x * second[5][i];
    return std::sqrt(derivative_norms::squared(sum));
}

template <typename T>
void expect_bound_of_all_coefficients(Random& random) {
    std::array<T, 6> around;
    for (T& value : around) value = random_value<T>(random);
    const double deviation = random.chance(0.2) ? 0.0 : random.scale(1e-4, 10.0);
    const Vec3 p = random.scale(0.1, 10.0) * random.direction(),
               q = random.scale(0.1, 10.0) * random.direction();
    PlaneBendBound<T> bound_of(p, q);
    std::vector<Second<T>> pieces;
    for (int i = random.integer(1, 10); i > 0; --i) {
        bound_of.add(pieces.emplace_back(random_coefficients<T>(random, around, deviation)));
    }
    const PlaneBend bound = bound_of.bound();
    for (int angle = 0; angle < 180; angle += 3) {
        const Vec2 v = direction_at(angle * std::numbers::pi / 180.0);
        for (const Second<T>& piece : pieces) {
            for (std::size_t i = 0; i < 64; ++i) {
                const double bend = bend_along<T>(piece, i, v.x * p + v.y * q);
                ASSERT_LE(bend, bound.most * (1.0 + 1e-12));
                ASSERT_LE(bend, bound.form(v) * (1.0 + 1e-12));
            }
        }
    }
}

TEST(PlaneBendBound, IsNeverBelowACoefficientInAnyDirection) {
    const int cases = test::case_count(200);
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = 14000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        if (random.chance(0.5)) {
            expect_bound_of_all_coefficients<double>(random);
        } else {
            expect_bound_of_all_coefficients<Vec3>(random);
        }
        if (HasFatalFailure()) return;
    }
}

// Where all coefficients are the same, of a displacement in one direction, nothing is lost.
TEST(PlaneBendBound, IsTheBendInEachDirectionIfTheSecondDerivativeIsConstant) {
    Second<double> second{};
    second[0].fill(2.0);   // xx
    second[1].fill(-0.5);  // yy
    PlaneBendBound<double> bound_of(Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0});
    bound_of.add(second);
    const PlaneForm form = bound_of.bound().form;
    EXPECT_NEAR(form.xx, 2.0, 1e-6);
    EXPECT_NEAR(form.xy, 0.0, 1e-6);
    EXPECT_NEAR(form.yy, 0.5, 1e-6);
    EXPECT_NEAR(bound_of.bound().most, 2.0, 1e-6);
}

}  // namespace
}  // namespace pectin

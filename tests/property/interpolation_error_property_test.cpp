// The bound of the interpolation error on random triangles and deformations of every kind, against
// the exact image, which is sampled densely.
//
// Source: S. Waldron. The error in linear interpolation at the vertices of a simplex. SIAM Journal
// on Numerical Analysis 35(3), 1998.
#include "ffd/interpolation_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "support/exact_surface.h"
#include "support/random_ellipsoid.h"
#include "support/random_gesture.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;
using Corners = InterpolationError::Corners;

// Of the samples along each side of a triangle.
constexpr int kSamples = 12;

// A random part of a face of the mesh, perhaps a small one.
Corners random_triangle(const TriMesh& mesh, Random& random) {
    while (true) {
        const FaceId f{
            static_cast<std::uint32_t>(random.integer(0, static_cast<int>(mesh.face_slots()) - 1))};
        if (!mesh.is_live(f)) continue;
        Corners corners = test::corners_of(mesh, f);
        const double size = random.scale(0.01, 1.0), s = random.uniform(0.0, 1.0);
        const Vec3 middle = test::point_of(corners, Vec3{s, (1.0 - s) * 0.3, (1.0 - s) * 0.7});
        for (Vec3& corner : corners) corner = middle + size * (corner - middle);
        return corners;
    }
}

struct Ratios {
    std::vector<double> one_step, several_steps;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[values.size() / 2];
}

void expect_same_bound_in_any_order(const InterpolationError& error, std::vector<Corners> before,
                                    double bound, Random& random) {
    const auto first = static_cast<std::size_t>(random.integer(0, 2));
    const bool swaps = random.chance(0.5);
    for (Corners& corners : before) {
        std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first),
                    corners.end());
        if (swaps) std::swap(corners[0], corners[1]);
    }
    // It may be infinite.
    const double other = error.bound(before);
    EXPECT_TRUE(other == bound || std::abs(other - bound) <= 1e-6 * bound) << other << ' ' << bound;
}

void expect_bounds(const Warp& warp, const TriMesh& mesh, Random& random, Ratios& ratios) {
    test::ExactImage image_of;
    image_of.add(warp);
    const InterpolationError error(warp);
    const double size = mesh.bounding_box().diagonal();
    for (int i = 0; i < 20; ++i) {
        const Corners rest = random_triangle(mesh, random);
        std::vector<Corners> before(1, rest);
        for (const Deformation& step : warp.steps) {
            Corners& next = before.emplace_back(before.back());
            for (Vec3& corner : next) corner = image(step, corner);
        }
        const Corners after = before.back();
        before.pop_back();
        const double bound = error.bound(before);
        const double farthest = test::sampled_error(image_of, rest, after, kSamples);
        ASSERT_LE(farthest, bound);
        expect_same_bound_in_any_order(error, before, bound, random);
        if (bound > 1e-4 * size && farthest > 0.0) {
            (warp.steps.size() == 1 ? ratios.one_step : ratios.several_steps)
                .push_back(bound / farthest);
        }
        const ErrorEllipsoid had = test::random_ellipsoid(
            random, random.chance(0.2) ? 0.0 : size * random.scale(1e-5, 0.1));
        // Where nothing moves no rounding is counted, but the members are rounded.
        const ErrorEllipsoid has = ErrorEllipsoid::sum(error.accumulated(had, bound, before),
                                                       ErrorEllipsoid::ball(1e-14 * size));
        test::for_each_sample(kSamples, [&](const Vec3& weights) {
            const Vec3 x = test::point_of(rest, weights) + test::random_member(had, random);
            ASSERT_TRUE(test::contains(has, image_of(x) - test::point_of(after, weights)));
        });
    }
}

TEST(InterpolationError, IsNeverAboveItsBound) {
    const int cases = test::case_count(100);
    Ratios ratios;
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = 8000 + static_cast<std::uint64_t>(i);
        Random random(seed);
        const auto [mesh, description] = test::random_mesh(random);
        const auto [warp, gesture] = test::random_gesture(mesh, random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description + "; " + gesture);
        expect_bounds(warp, mesh, random, ratios);
        if (HasFatalFailure() || HasFailure()) return;
    }
    std::printf(
        "seeds 8000 to %d; bound over error, median: %.2f for %zu triangles in one step, "
        "%.2f for %zu in several\n",
        8000 + cases - 1, median(ratios.one_step), ratios.one_step.size(),
        median(ratios.several_steps), ratios.several_steps.size());
    EXPECT_LE(median(ratios.one_step), 4.0);
}

}  // namespace
}  // namespace pectin

// The bound of the interpolation error where triangles or numbers are extreme.
#include "ffd/interpolation_error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "ffd/drag_plan.h"
#include "support/exact_surface.h"
#include "support/random_ellipsoid.h"

namespace pectin {
namespace {

using test::Corners;

// Moves the control points of a lattice by displacement(rest position).
template <typename Displacement>
Warp lattice_warp(const Lattice& lattice, const Displacement& displacement) {
    std::vector<Vec3> all(lattice.control_count());
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                all[lattice.control_index({i, j, k})] = displacement(lattice.rest({i, j, k}));
            }
        }
    }
    return Warp{{LatticeField(lattice, std::move(all))}};
}

// Rounding leaves of such triangles no second direction of their plane.
TEST(InterpolationError, IsBoundedOnTrianglesWithoutArea) {
    struct Case {
        Corners corners;
        Vec3 bent;  // the warp bends along it
    };
    const std::array<Case, 2> cases{{
        {{Vec3{0.0, 0.0, 0.0}, Vec3{0.2857142857142857, 0.42857142857142855, 0.8571428571428571},
          Vec3{0.14240765858978044, 0.21361148788467066, 0.42722297576934132}},
         {0.96768540546491089, -0.1127696378022127, -0.22553927560442541}},
        {{Vec3{-0.1569955874739446, -0.81619109073471008, 0.72704947529132768},
          Vec3{0.65950099345378155, -1.2244393811985732, 1.1352977657551908},
          Vec3{0.47279278033943239, -1.1310852746363986, 1.0419436591930162}},
         {-0.4620688533891143, -0.62709344388522725, 0.62709344388522725}},
    }};
    const Lattice lattice{
        .origin = Vec3{-20.0}, .cell = Vec3{4.0}, .deformable = IVec3{11}, .margin = IVec3{0}};
    for (const Case& c : cases) {
        const Warp warp = lattice_warp(lattice, [&](const Vec3& x) {
            return Vec3{0.0, 0.0, 0.05 * glm::dot(c.bent, x) * glm::dot(c.bent, x)};
        });
        test::ExactImage image_of;
        image_of.add(warp);
        Corners after = c.corners;
        for (Vec3& corner : after) corner = image_of(corner);
        const double farthest = test::sampled_error(image_of, c.corners, after, 20);
        EXPECT_GT(farthest, 1e-6);
        EXPECT_LE(farthest, InterpolationError(warp).bound(std::span(&c.corners, 1)));
    }
}

// The bound of a brush and a triangle that are `scale` times as large as at 1.
double bound_at(double scale) {
    const Vec3 from{0.1 * scale, 0.2 * scale, 0.0};
    const DragPlan plan{
        .moves = {{.from = from, .to = from + Vec3{0.1 * scale, 0.0, 0.3 * scale}}},
        .lattice = brush_lattice(from, scale, 3),
    };
    const Warp warp = std::get<PlannedDrag>(plan_drag(plan)).warp;
    const Corners corners{from + scale * Vec3{0.1, 0.0, 0.0}, from + scale * Vec3{0.0, 0.1, 0.0},
                          from + scale * Vec3{0.0, 0.0, 0.1}};
    return InterpolationError(warp).bound(std::span(&corners, 1));
}

// Powers of two change no digit, as long as nothing overflows or underflows.
TEST(InterpolationError, IsBoundedAlikeAtAnyScale) {
    const double bound = bound_at(1.0);
    EXPECT_GT(bound, 1e-4);
    EXPECT_LT(bound, 1.0);
    for (const int exponent : {-200, -133, -100, -20, 20, 100, 133, 200}) {
        const double scale = std::ldexp(1.0, exponent);
        EXPECT_NEAR(bound_at(scale) / scale, bound, 1e-6 * bound) << "at 2^" << exponent;
    }
}

// What the warp makes of errors longer than its lattice: from any point to one that does not move.
TEST(InterpolationError, AddsDisplacementsToErrorsLongerThanTheLattice) {
    const Vec3 d{0.0, 0.0, 1.0};
    const Lattice lattice{
        .origin = Vec3{-4.0}, .cell = Vec3{1.0}, .deformable = IVec3{9}, .margin = IVec3{0}};
    const Warp warp = lattice_warp(lattice, [&](const Vec3&) { return d; });
    const InterpolationError error(warp);
    test::ExactImage image_of;
    image_of.add(warp);
    constexpr double kLong = 100.0;
    const ErrorEllipsoid had = ErrorEllipsoid::ball(kLong);
    for (double z = -5.5; z < 5.5; z += 0.5) {
        const Vec3 p{0.0, 0.0, z};
        const Corners corners{p, p + Vec3{1e-3, 0.0, 0.0}, p + Vec3{0.0, 1e-3, 0.0}};
        const std::span<const Corners> before(&corners, 1);
        const ErrorEllipsoid has = error.accumulated(had, error.bound(before), before);
        for (const Vec3& v : {Vec3{0.0, 0.0, kLong}, Vec3{0.0, 0.0, -kLong}, Vec3{kLong, 0.0, 0.0},
                              Vec3{0.0, 0.6 * kLong, -0.8 * kLong}}) {
            EXPECT_TRUE(test::contains(has, image_of(p + v) - image_of(p))) << z;
        }
        EXPECT_LE(has.radius(), kLong + 1.001);
    }
}

}  // namespace
}  // namespace pectin

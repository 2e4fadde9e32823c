// Lattices, and the direct evaluation of a displaced lattice.
#include "ffd/lattice.h"

#include <gtest/gtest.h>

#include <limits>

#include "ffd/cubic_basis.h"
#include "ffd/lattice_field.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

LatticeField random_field(LatticeRandom& random) {
    const Lattice lattice = random.lattice(Vec3{0.0}, 1, 6);
    return {lattice, random.vectors(lattice.control_count())};
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Lattice, InfluencesTwoCellsBeyondItsDeformableZone) {
    const Lattice lattice{.origin = {1, 2, 3}, .cell = {1, 0.5, 0.25}, .deformable = {1, 3, 5}};
    const Box zone = lattice.influenced_zone();
    EXPECT_EQ(zone.min, Vec3(-1, 1, 2.5));
    EXPECT_EQ(zone.max, Vec3(3, 4, 4.5));
    EXPECT_EQ(lattice.smallest_cell_extent(), 0.25);
    EXPECT_EQ(lattice.rest({0, 2, 4}), Vec3(1, 3, 4));
    EXPECT_EQ(lattice.parameter({2, 3, 4}), Vec3(1, 2, 4));
    EXPECT_TRUE(lattice.influences({1, 2, 3}));
    EXPECT_FALSE(lattice.influences({-1, 2, 3}));
    EXPECT_FALSE(lattice.influences({1, 2, 4.5}));
    EXPECT_FALSE(lattice.influences(Vec3{std::numeric_limits<double>::quiet_NaN()}));
}

TEST(Lattice, NumbersItsControlPointsWithoutGapsFirstAxisFastest) {
    const Lattice lattice{.deformable = {2, 3, 4}};
    std::size_t expected = 0;
    for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 2; ++i) EXPECT_EQ(lattice.control_index({i, j, k}), expected++);
        }
    }
    EXPECT_EQ(lattice.control_count(), expected);
}

TEST(Lattice, EmbedsSpaceAsTheIdentityByLinearPrecision) {
    LatticeRandom random{3};
    SCOPED_TRACE("seed 3");
    for (int trial = 0; trial < 100; ++trial) {
        const Lattice lattice = random.lattice(Vec3{0.0}, 1, 6);
        const Vec3 x = random.point_in(lattice, 0.001);
        const Vec3 u = lattice.parameter(x);
        Vec3 sum{0.0};
        for (int i = -4; i < 11; ++i) {
            for (int j = -4; j < 11; ++j) {
                for (int k = -4; k < 11; ++k) {
                    sum +=
                        basis(u.x - i) * basis(u.y - j) * basis(u.z - k) * lattice.rest({i, j, k});
                }
            }
        }
        EXPECT_LT(glm::length(sum - x), 1e-13 * (1.0 + glm::length(x)));
    }
}

TEST(Lattice, IsValidOnlyIfFiniteWithPositiveCellsAndSomethingToDeform) {
    EXPECT_TRUE((Lattice{.deformable = {kMinDeformable, 3, kMaxDeformable}}.is_valid()));
    EXPECT_FALSE((Lattice{.deformable = {3, 0, 3}}.is_valid()));
    EXPECT_FALSE((Lattice{.deformable = {3, 3, kMaxDeformable + 1}}.is_valid()));
    EXPECT_FALSE((Lattice{.cell = {1, 0, 1}}.is_valid()));
    EXPECT_FALSE((Lattice{.cell = {1, -1, 1}}.is_valid()));
    EXPECT_FALSE((Lattice{.cell = {1, 1, kInfinity}}.is_valid()));
    EXPECT_FALSE((Lattice{.origin = {0, 0, -kInfinity}}.is_valid()));
    EXPECT_FALSE((Lattice{.cell = {1, 1e308, 1}, .deformable = IVec3{9}}.is_valid()));
}

TEST(BrushLattice, ReachesItsRadiusFromTheGrabbedPoint) {
    for (const int span : {1, 2, 3, 4, 7}) {
        const Vec3 centre{3, -4, 5};
        const Box zone = brush_lattice(centre, 1.5, span).influenced_zone();
        EXPECT_LT(glm::length(zone.min - (centre - 1.5)), 1e-14) << span;
        EXPECT_LT(glm::length(zone.max - (centre + 1.5)), 1e-14) << span;
    }
    EXPECT_EQ(brush_lattice(Vec3{0.0}, 3.0, 3).cell, Vec3(1.0));
}

TEST(FitLattice, SpansTheBoxWithItsDeformableControlPoints) {
    const Box box{.min = {-1, 0, 2}, .max = {1, 3, 10}};
    const Lattice lattice = fit_lattice(box, {3, 4, 2});
    EXPECT_EQ(lattice.rest({1, 1, 1}), box.min);
    EXPECT_EQ(lattice.rest({3, 4, 2}), box.max);
    EXPECT_TRUE(lattice.is_valid());
    EXPECT_EQ(lattice.counts(), IVec3(3, 4, 2));
    EXPECT_EQ(lattice.deformable, IVec3(5, 6, 4)) << "one layer more on each side";
    EXPECT_EQ(lattice.first_index(), IVec3(-1));
    EXPECT_EQ(lattice.last_index(), IVec3(3, 4, 2));
    EXPECT_EQ(lattice.rest(lattice.control_of_user_index({0, 0, 0})), box.min);
    EXPECT_EQ(lattice.user_index(lattice.control_of_user_index({2, -1, 1})), IVec3(2, -1, 1));
}

TEST(FitLattice, CentresASingleControlPointAndStillHoldsTheBox) {
    const Box box{.min = {-1, 0, 2}, .max = {1, 3, 10}};
    const Lattice lattice = fit_lattice(box, {1, 4, 1});
    EXPECT_EQ(lattice.rest({2, 2, 2}), Vec3(0, 1, 6));
    EXPECT_EQ(lattice.first_index(), IVec3(-2, -1, -2)) << "two layers beyond a single point";
    EXPECT_EQ(lattice.cell, Vec3(1, 1, 4));
    EXPECT_TRUE(lattice.influences(box.min));
    EXPECT_TRUE(lattice.influences(box.max));
}

TEST(FitLattice, GivesAFlatBoxTheLargestCellOfItsOtherAxes) {
    const Lattice plane = fit_lattice({.min = {0, 1, 0}, .max = {2, 1, 6}}, {3, 3, 3});
    EXPECT_EQ(plane.cell, Vec3(1, 3, 3));
    EXPECT_EQ(plane.rest({2, 2, 2}), Vec3(1, 1, 3));
    const Lattice rounded = fit_lattice({.min = {0, 1, 0}, .max = {2, 1 + 1e-15, 6}}, {3, 3, 3});
    EXPECT_EQ(rounded.cell, Vec3(1, 3, 3));
    const Lattice point = fit_lattice({.min = Vec3{5.0}, .max = Vec3{5.0}}, {1, 2, 3});
    EXPECT_EQ(point.cell, Vec3(1.0));
    EXPECT_EQ(point.rest(point.margin), Vec3(5, 4.5, 4));
}

TEST(FitLattice, IsValidUpToTheMostPointsPerAxisAndNoFurther) {
    const Box box{.min = Vec3{-1.0}, .max = Vec3{1.0}};
    EXPECT_TRUE(fit_lattice(box, IVec3{kMaxFitted}).is_valid());
    Lattice lattice = fit_lattice(box, {4, 4, 4});
    lattice.deformable.x = kMaxDeformable + 1;
    EXPECT_FALSE(lattice.is_valid());
    for (const int wrong : {-1, 3}) {
        lattice = fit_lattice(box, {4, 4, 4});
        lattice.margin.y = wrong;
        EXPECT_FALSE(lattice.is_valid()) << wrong;
    }
    lattice = {.deformable = {1, 2, 1}, .margin = {0, 1, 0}};
    EXPECT_FALSE(lattice.is_valid()) << "no control point is left between the margins";
}

TEST(LatticeField, IsExactlyZeroOnTheBorderOfItsZoneAndOutside) {
    LatticeRandom random{4};
    SCOPED_TRACE("seed 4");
    for (int trial = 0; trial < 200; ++trial) {
        const LatticeField field = random_field(random);
        const Vec3 x = random.point_outside(field.lattice(), 9.0);
        EXPECT_EQ(field.displacement(x), Vec3(0.0));
        EXPECT_EQ(field.jacobian(x), Mat3(1.0));
    }
}

TEST(LatticeField, TranslatesSpaceIfAllControlPointsMoveAlike) {
    const Lattice lattice{.cell = {1, 2, 3}, .deformable = {5, 5, 5}};
    const LatticeField field{lattice, std::vector<Vec3>(125, Vec3{1, -2, 3})};
    EXPECT_LT(glm::length(field.displacement({2.2, 3.4, 7.3}) - Vec3(1, -2, 3)), 1e-14);
    EXPECT_GT(field.displacement({-1.999, 0, 0}).x, 0.0);
}

// On lines through every kind of cell border, including that of the influenced zone, the one-sided
// first and second differences on both sides agree up to the jump of the third derivative.
TEST(LatticeField, HasTwoContinuousDerivativesAcrossEveryCellBorder) {
    LatticeRandom random{5};
    SCOPED_TRACE("seed 5");
    const double h = 1e-3;  // in cells
    for (int trial = 0; trial < 60; ++trial) {
        const LatticeField field = random_field(random);
        const Lattice& lattice = field.lattice();
        const int axis = trial % 3;
        for (int knot = -2; knot <= lattice.deformable[axis] + 1; ++knot) {
            Vec3 x = random.point_in(lattice, 0.001);
            x[axis] = lattice.origin[axis] + lattice.cell[axis] * knot;
            Vec3 step{0.0};
            step[axis] = h * lattice.cell[axis];
            const auto at = [&](double steps) { return field.displacement(x + steps * step); };
            const auto first = [&](double side) {
                return side * (4.0 * at(side) - 3.0 * at(0.0) - at(2.0 * side)) / (2.0 * h);
            };
            const auto second = [&](double side) {
                return (at(0.0) - 2.0 * at(side) + at(2.0 * side)) / (h * h);
            };
            EXPECT_LT(glm::length(first(1.0) - first(-1.0)), 20.0 * h * h) << knot;
            EXPECT_LT(glm::length(second(1.0) - second(-1.0)), 20.0 * h) << knot;
        }
    }
}

TEST(LatticeField, JacobianMatchesCentralDifferencesInWorldUnits) {
    LatticeRandom random{6};
    SCOPED_TRACE("seed 6");
    const double h = 1e-5;
    for (int trial = 0; trial < 200; ++trial) {
        const LatticeField field = random_field(random);
        const Vec3 x = random.point_in(field.lattice(), 0.001);
        const Mat3 jacobian = field.jacobian(x);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 step{0.0};
            step[axis] = h;
            const Vec3 difference =
                (field.displacement(x + step) - field.displacement(x - step)) / (2.0 * h);
            Vec3 column = jacobian[axis];
            column[axis] -= 1.0;
            EXPECT_LT(glm::length(column - difference), 1e-7);
        }
    }
}

TEST(Covariant, FollowsTheNormalOfADeformedTangentPlane) {
    LatticeRandom random{7};
    SCOPED_TRACE("seed 7");
    for (int trial = 0; trial < 200; ++trial) {
        const Mat3 jacobian{random.vector(-2, 2), random.vector(-2, 2), random.vector(-2, 2)};
        const Vec3 s = random.vector(-1, 1), t = random.vector(-1, 1);
        const Vec3f n{glm::normalize(glm::cross(s, t))};
        const Vec3 expected =
            glm::normalize(glm::cross(contravariant(jacobian, s), contravariant(jacobian, t)));
        EXPECT_LT(glm::length(Vec3{covariant(jacobian, n)} - expected), 1e-4);
    }
}

TEST(Covariant, KeepsNormalsBitForBitUnderTheIdentityAndZeroAsZero) {
    const Vec3f n{0.1f, -0.7f, -0.0f};
    EXPECT_EQ(covariant(Mat3{1.0}, n), n);
    EXPECT_EQ(covariant(Mat3{2.0}, Vec3f{0.0f}), Vec3f(0.0f));
    EXPECT_EQ(covariant(Mat3{0.0}, n), Vec3f(0.0f));
}

}  // namespace
}  // namespace pectin

// What the rings and the tint of the window show of a brush.
#include "ffd/brush_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ffd/drag_solver.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

constexpr Vec3 kAxis{1.0, 0.0, 0.0};

double half_along_axis(int span, Falloff falloff) {
    return BrushProfile(span, falloff).distance_at(0.5, kAxis);
}

TEST(BrushProfile, OfASharpBrushIsNarrowerTheMoreControlPointsThereAre) {
    // With one control point the weight is β(2x)/β(0), which is half where 3 (2x)² (2 − 2x) = 2.
    const double one = 2.0 * half_along_axis(1, Falloff::sharp);
    EXPECT_NEAR(3.0 * one * one * (2.0 - one), 2.0, 1e-4);
    EXPECT_NEAR(half_along_axis(3, Falloff::sharp), 0.3065, 1e-4);
    EXPECT_NEAR(half_along_axis(16, Falloff::sharp), 0.1112, 1e-4);
    // Even numbers have no control point at the grabbed point itself, and are a little wider.
    for (int span = 1; span <= 14; ++span) {
        EXPECT_GT(half_along_axis(span, Falloff::sharp), half_along_axis(span + 2, Falloff::sharp))
            << span;
    }
}

TEST(BrushProfile, OfAPlateauIsWiderTheMoreControlPointsThereAre) {
    EXPECT_NEAR(half_along_axis(1, Falloff::plateau), half_along_axis(1, Falloff::sharp), 1e-6)
        << "a single control point";
    EXPECT_NEAR(half_along_axis(3, Falloff::plateau), 0.393, 0.005);
    EXPECT_NEAR(half_along_axis(5, Falloff::plateau), 0.535, 0.005);
    for (int span = 3; span < 16; ++span) {
        EXPECT_LT(half_along_axis(span, Falloff::plateau),
                  half_along_axis(span + 1, Falloff::plateau))
            << span;
    }
}

TEST(BrushProfile, OfAPlateauIsAboutRoundAndFlatAtItsTop) {
    for (int span = 3; span <= 9; ++span) {
        const BrushProfile profile(span, Falloff::plateau);
        const double half = profile.distance_at(0.5, kAxis);
        for (const Vec3& direction : {Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{2, 1, 0}}) {
            EXPECT_NEAR(profile.distance_at(0.5, glm::normalize(direction)) / half, 1.0, 0.05)
                << span;
        }
        if (span < 5) continue;
        EXPECT_GT(profile.weight(0.2 * kAxis), 0.95) << span;
    }
}

// With many control points most of the lattice does not move, and the ring says so.
TEST(BrushProfile, MotionEndsWhereNoControlPointThatMovesReaches) {
    EXPECT_NEAR(BrushProfile(3, Falloff::sharp).distance_at(kEndOfMotion, kAxis), 0.86, 0.01);
    const double end = BrushProfile(16, Falloff::sharp).distance_at(kEndOfMotion, kAxis);
    EXPECT_LT(end, 3.5 / 9.5);
    EXPECT_GT(end, 0.75 * 3.5 / 9.5);
    EXPECT_GT(BrushProfile(16, Falloff::plateau).distance_at(kEndOfMotion, kAxis), 0.95);
}

TEST(BrushProfile, TheWeightAtTheDistanceIsTheLevelAndLessBeyond) {
    LatticeRandom random{81};
    SCOPED_TRACE("seed 81");
    for (const Falloff falloff : {Falloff::sharp, Falloff::plateau}) {
        for (const int span : {1, 2, 3, 4, 6, 9, 16}) {
            const BrushProfile profile(span, falloff);
            for (int i = 0; i < 20; ++i) {
                const Vec3 direction = glm::normalize(random.vector(-1.0, 1.0));
                for (const double level : {kEndOfMotion, 0.5}) {
                    const double distance = profile.distance_at(level, direction);
                    EXPECT_NEAR(profile.weight(distance * direction), level, 1e-5);
                    for (double beyond = 1.01; beyond < 3.0; beyond *= 1.05) {
                        EXPECT_LT(profile.weight(beyond * distance * direction), level);
                    }
                }
            }
        }
    }
}

TEST(BrushProfile, IsTheFieldOfADragWithThatRadius) {
    LatticeRandom random{82};
    SCOPED_TRACE("seed 82");
    const Vec3 centre{3.0, -1.0, 0.5};
    const double radius = 0.7;
    for (const Falloff falloff : {Falloff::sharp, Falloff::plateau}) {
        const std::array<Handle, 1> handle{Handle{centre}};
        const auto solved = DragSolver::create(brush_lattice(centre, radius, 4), handle, {},
                                               std::nullopt, kMaxControlGain, falloff);
        const DragField& field = std::get<DragSolver>(solved).field();
        const BrushProfile profile(4, falloff);
        for (int i = 0; i < 100; ++i) {
            const Vec3 offset = random.vector(-1.1, 1.1);
            DragWeight weight;
            field.weights(centre + radius * offset, {&weight, 1});
            EXPECT_NEAR(static_cast<double>(weight.w), profile.weight(offset), 1e-6);
        }
    }
}

// The tint interpolates the samples as graphics memory does.
TEST(BrushProfile, InterpolatedSamplesAreTheWeightsWithinOnePercent) {
    LatticeRandom random{83};
    SCOPED_TRACE("seed 83");
    constexpr int kCount = BrushProfile::kSamples;
    for (const Falloff falloff : {Falloff::sharp, Falloff::plateau}) {
        for (const int span : {1, 3, 5, 9}) {
            const BrushProfile profile(span, falloff);
            ASSERT_EQ(profile.samples().size(), std::size_t{kCount * kCount * kCount});
            for (int i = 0; i < 300; ++i) {
                const Vec3 offset = random.vector(0.0, 0.999);
                const Vec3 at = offset * double{kCount - 1};
                const IVec3 cell{at};
                const Vec3 inside = at - Vec3{cell};
                double sum = 0.0;
                for (int corner = 0; corner < 8; ++corner) {
                    const IVec3 step{corner % 2, corner / 2 % 2, corner / 4};
                    double share = 1.0;
                    for (int axis = 0; axis < 3; ++axis) {
                        share *= step[axis] == 1 ? inside[axis] : 1.0 - inside[axis];
                    }
                    const IVec3 sample = cell + step;
                    const int index = sample.x + kCount * (sample.y + kCount * sample.z);
                    sum += share * profile.samples()[static_cast<std::size_t>(index)] / 255.0;
                }
                EXPECT_NEAR(sum, profile.weight(offset), 0.01) << span;
            }
        }
    }
}

// The lattice is a grid, so that no line of equal weight is a circle. That of half the motion
// nearly is. The outer one, where the weight is a 256th, reaches less far along the axes, where the
// lattice ends; of a plateau it also waves by some percent, because the control points at the rim
// of a ball are not at equal distances from its middle.
TEST(BrushProfile, TheRingOfHalfMotionIsRoundAndTheOuterOneOnlyNearly) {
    constexpr double kPi = 3.14159265358979323846;
    for (const Falloff falloff : {Falloff::sharp, Falloff::plateau}) {
        for (int span = falloff == Falloff::sharp ? 1 : 5; span <= 16; ++span) {
            const BrushProfile profile(span, falloff);
            const auto unevenness = [&](double level) {
                double least = 10.0, most = 0.0;
                for (int i = 0; i <= 90; ++i) {
                    const double angle = 0.5 * kPi * i / 90.0;
                    const double distance =
                        profile.distance_at(level, {std::cos(angle), std::sin(angle), 0.0});
                    least = std::min(least, distance);
                    most = std::max(most, distance);
                }
                return most / least - 1.0;
            };
            EXPECT_LT(unevenness(0.5), falloff == Falloff::sharp ? 0.045 : 0.01) << span;
            EXPECT_LT(unevenness(kEndOfMotion), 0.15) << span;
        }
    }
}

}  // namespace
}  // namespace pectin

// Drags that are met on both sides of a plane and on the plane.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ffd/drag_plan.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

constexpr MirrorPlane kPlane{.axis = 0, .at = 0.0};

PlannedDrag planned(const DragPlan& plan) {
    auto result = plan_drag(plan);
    if (const auto* refusal = std::get_if<DragRefusal>(&result)) {
        throw std::runtime_error(refusal->what);
    }
    return std::move(std::get<PlannedDrag>(result));
}

std::string refusal(const DragPlan& plan) {
    const auto result = plan_drag(plan);
    const auto* refused = std::get_if<DragRefusal>(&result);
    return refused ? refused->what : "";
}

DragPlan plan(const Vec3& from, const Vec3& to, bool fold_free, double radius = 1.0) {
    return {.moves = {{from, to}},
            .fold_free = fold_free,
            .plane = kPlane,
            .lattice = brush_lattice(from, radius, 3),
            .is_centred_on_point = true};
}

Vec3 warped(const Warp& warp, Vec3 x) {
    for (const Deformation& step : warp.steps) {
        const DragStep& drag = std::get<DragStep>(step);
        std::vector<DragWeight> weights(drag.displacements.size());
        drag.weights(x, weights);
        x = displaced(x, weights, drag.displacements);
    }
    return x;
}

TEST(SymmetricDrag, BringsBothPointsToTheirTargetsAtAnyDistanceFromThePlane) {
    for (const double x : {3.0, 0.8, 0.3, 0.05, 0.01, 0.002}) {
        for (const bool fold_free : {false, true}) {
            const Vec3 from{x, 0.2, 0.1}, to{1.3 * x + 0.01, 0.5, -0.2};
            const Warp warp = planned(plan(from, to, fold_free)).warp;
            EXPECT_LT(glm::distance(warped(warp, from), to), 1e-5) << x;
            EXPECT_LT(glm::distance(warped(warp, kPlane.image(from)), kPlane.image(to)), 1e-5) << x;
        }
    }
}

TEST(SymmetricDrag, MovesImagesToImagesAndThePlaneWithinItselfBitForBit) {
    test::Random random(81);
    for (int round = 0; round < test::case_count(40); ++round) {
        const double side = random.chance(0.5) ? -1.0 : 1.0;
        const Vec3 from{side * random.uniform(0.02, 2.0), random.uniform(-1, 1), 0.0};
        DragPlan drag = plan(from, from + Vec3{side * 0.3, 0.4, 0.6}, round % 2 == 0);
        drag.pins = {from + Vec3{0.0, 0.5, 0.2}};
        if (round % 3 == 0) {
            drag.moves[0].twist = {{1, 2, 0.5}, 20.0};
            drag.moves[0].scale = 1.2;
        }
        const Warp warp = planned(drag).warp;
        for (int i = 0; i < 200; ++i) {
            const Vec3 x = from + random.uniform(0.0, 1.5) * random.direction();
            EXPECT_EQ(kPlane.image(warped(warp, x)), warped(warp, kPlane.image(x)));
            EXPECT_EQ(warped(warp, kPlane.onto(x)).x, 0.0);
        }
        for (const Vec3& pin : {drag.pins[0], kPlane.image(drag.pins[0])}) {
            EXPECT_LT(glm::distance(warped(warp, pin), pin), 1e-6);
        }
    }
}

TEST(SymmetricDrag, IsTheSameFromEitherSide) {
    const Vec3 from{0.4, 0.1, 0.0}, to{0.7, 0.9, 0.3};
    DragPlan right = plan(from, to, true);
    DragPlan left = plan(kPlane.image(from), kPlane.image(to), true);
    right.moves[0].twist = {{1, 1, 0}, 25.0};
    right.moves[0].scale = 0.9;
    left.moves[0].twist = {kPlane.image_of_vector({-1, -1, 0}), 25.0};
    left.moves[0].scale = 0.9;
    const Warp a = planned(right).warp, b = planned(left).warp;
    test::Random random(82);
    for (int i = 0; i < 500; ++i) {
        const Vec3 x = random.uniform(0.0, 1.5) * random.direction();
        EXPECT_LT(glm::distance(warped(a, x), warped(b, x)), 1e-6);
    }
}

TEST(SymmetricDrag, IsAsLocalAsItsBrush) {
    const Vec3 from{3, 0, 0};
    const Warp symmetric = planned(plan(from, {3, 0, 0.3}, false)).warp;
    DragPlan alone = plan(from, {3, 0, 0.3}, false);
    alone.plane.reset();
    const Warp plain = planned(alone).warp;
    test::Random random(83);
    for (int i = 0; i < 500; ++i) {
        const Vec3 x = from + random.uniform(0.0, 1.5) * random.direction();
        EXPECT_LT(glm::distance(warped(symmetric, x), warped(plain, x)), 1e-7);
    }
    EXPECT_EQ(symmetric.zones().size(), 2u);
    EXPECT_EQ(warped(symmetric, {0.5, 0, 0}), Vec3(0.5, 0, 0));
}

TEST(SymmetricDrag, OfAPointOnThePlaneIsThePlainDrag) {
    const Vec3 from{0, 0, 1}, to{0, 0.2, 1.3};
    const Warp symmetric = planned(plan(from, to, true)).warp;
    DragPlan alone = plan(from, to, true);
    alone.plane.reset();
    test::Random random(84);
    for (int i = 0; i < 500; ++i) {
        const Vec3 x = from + random.direction();
        EXPECT_LT(glm::distance(warped(symmetric, x), warped(planned(alone).warp, x)), 1e-7);
    }
    EXPECT_EQ(symmetric.zones().size(), 1u);
}

TEST(SymmetricDrag, NeverFoldsWhereItsTwoBrushesMeet) {
    test::Random random(85);
    for (int round = 0; round < test::case_count(40); ++round) {
        const Vec3 from{random.uniform(0.05, 1.2), 0, 0};
        const Vec3 to{random.uniform(0.05, 2.0), random.uniform(-1, 1), random.uniform(-1, 1)};
        const Warp warp = planned(plan(from, to, true)).warp;
        for (const Deformation& step : warp.steps) {
            const auto fields = std::get<DragStep>(step).lattice_fields();
            for (int i = 0; i < 500; ++i) {
                const Vec3 x{random.uniform(-2, 2), random.uniform(-1.5, 1.5),
                             random.uniform(-1, 1)};
                Mat3 j{1.0};
                for (const auto& field : fields) j += field.jacobian(x) - Mat3{1.0};
                ASSERT_GT(glm::determinant(j), 0.0) << "seed 85, round " << round;
            }
        }
    }
}

// A point on the plane meets its image, so no one-to-one deformation takes a point there.
TEST(SymmetricDrag, WithoutFoldingIsRefusedOnThePlaneBeforeAnyStep) {
    EXPECT_NE(refusal(plan({0.5, 0, 0}, {0, 0.3, 0}, true)).find("(0, 0.3, 0) is on the symmetry"),
              std::string::npos);
    EXPECT_EQ(refusal(plan({0.5, 0, 0}, {0.05, 0.3, 0}, true)), "");
    EXPECT_EQ(refusal(plan({0.5, 0, 0}, {0, 0.3, 0}, false)), "");
}

TEST(SymmetricDrag, RefusesToLeaveItsSideAndSaysHowFarItMayGo) {
    EXPECT_NE(refusal(plan({0.5, 0, 0}, {-0.2, 0.3, 0}, true)).find("(0, 0.3, 0)"),
              std::string::npos);
    EXPECT_NE(refusal(plan({0, 0, 0}, {0.2, 0.3, 0}, true)).find("(0, 0.3, 0)"), std::string::npos);
    EXPECT_NE(refusal(plan({1e-5, 0, 0}, {0.2, 0.3, 0}, false)).find("tear"), std::string::npos);
    EXPECT_EQ(refusal(plan({1e-5, 0, 0}, {1e-5, 0.3, 0}, false)), "");
    DragPlan twist = plan({0, 0, 0}, {0, 0, 0}, false);
    twist.moves[0].twist = {{0, 1, 0}, 20.0};
    EXPECT_NE(refusal(twist).find("only be twisted about its normal, x"), std::string::npos);
    twist.moves[0].twist = {{1, 0, 0}, 20.0};
    twist.moves[0].scale = 1.3;
    EXPECT_EQ(refusal(twist), "");
}

TEST(SymmetricDrag, RefusesMovesOfAPointAndItsImageThatDoNotMatch) {
    DragPlan both = plan({0.5, 0, 0}, {0.7, 0.3, 0}, false);
    both.moves.push_back({{-0.5, 0, 0}, {-0.7, 0.3, 0}});
    EXPECT_EQ(refusal(both), "");
    both.moves[1].to = {-0.7, 0.2, 0};
    EXPECT_NE(refusal(both).find("must agree"), std::string::npos);
    DragPlan pinned = plan({0.5, 0, 0}, {0.7, 0.3, 0}, false);
    pinned.pins = {{-0.5, 0, 0}};
    EXPECT_NE(refusal(pinned).find("is pinned"), std::string::npos);
}

}  // namespace
}  // namespace pectin

// The proof that space does not fold, and the fold-free drags that are composed of proven steps.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "ffd/drag_plan.h"
#include "ffd/drag_solver.h"
#include "ffd/fold_guard.h"
#include "ffd/injectivity.h"
#include "support/random_mesh.h"
#include "support/test_run.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

constexpr double kRadius = 1.0;

std::vector<Vec3> directions26() {
    std::vector<Vec3> all;
    for (int i = 0; i < 27; ++i) {
        const Vec3 d{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        if (d != Vec3{0.0}) all.push_back(glm::normalize(d));
    }
    return all;
}

Mat3 jacobian_at(const std::vector<LatticeField>& fields, const Vec3& x, double t = 1.0) {
    Mat3 j{1.0};
    for (const LatticeField& field : fields) j += t * (field.jacobian(x) - Mat3{1.0});
    return j;
}

DragStep brush_step(const Vec3& by, int span = 3) {
    const Lattice lattice = brush_lattice(Vec3{0.0}, kRadius, span);
    const std::array<Handle, 1> handles{Handle{}};
    const std::array<HandleMotion, 1> motions{HandleMotion{by}};
    return std::get<DragSolver>(DragSolver::create(lattice, handles, {})).step(motions);
}

// The displacement at which a brush begins to fold, from the gradient of w on a dense grid.
double true_limit(const Vec3& direction, int span) {
    const DragStep step = brush_step(direction, span);
    double least = 0.0;
    constexpr int kSteps = 96;
    for (int flat = 0; flat < kSteps * kSteps * kSteps; ++flat) {
        const Vec3 at{flat % kSteps, flat / kSteps % kSteps, flat / kSteps / kSteps};
        const Vec3 x = kRadius * (2.0 / kSteps * (at + 0.5) - 1.0);
        DragWeight weight;
        step.weights(x, {&weight, 1});
        least = std::min(least, glm::dot(Vec3{weight.gradient}, direction));
    }
    return -1.0 / least;
}

TEST(InjectiveLimit, IsBetweenNineTenthsAndAllOfTheTrueLimitOfABrush) {
    for (const Vec3& direction : {Vec3{0, 0, 1}, glm::normalize(Vec3{1, 1, 0}),
                                  glm::normalize(Vec3{-1, 1, 1}), glm::normalize(Vec3{3, 1, -2})}) {
        const double limit = true_limit(direction, 3);
        const double proven = 10.0 * injective_limit(brush_step(10.0 * direction).lattice_fields());
        // The margin kLeastStretch counts as reached.
        EXPECT_GT(proven / (1.0 - kLeastStretch), 0.9 * limit);
        EXPECT_LT(proven / (1.0 - kLeastStretch), limit * 1.001);
    }
}

TEST(InjectiveLimit, KeepsTheLeastStretchAtEveryPointForRandomLatticesAndConstraints) {
    LatticeRandom random(71);
    for (int round = 0; round < test::case_count(60); ++round) {
        const Lattice lattice = random.lattice(Vec3{0.0}, 1, 5);
        std::vector<Vec3> points;
        random.add_points(lattice, 1 + round % 3, points);
        std::vector<Handle> handles;
        std::vector<HandleMotion> motions;
        for (const Vec3& point : points) {
            handles.push_back({point});
            motions.push_back({random.vector(-4.0, 4.0) * lattice.cell});
        }
        const auto solved = DragSolver::create(lattice, handles, {});
        if (std::holds_alternative<DragRefusal>(solved)) continue;
        const auto fields = std::get<DragSolver>(solved).step(motions).lattice_fields();
        const double t = injective_limit(fields);
        ASSERT_GT(t, 0.0);
        ASSERT_LE(t, 1.0);
        for (int i = 0; i < 1000; ++i) {
            const Mat3 j = jacobian_at(fields, random.point_in(lattice, 0.0), t);
            ASSERT_GT(glm::determinant(j), points.size() == 1 ? 0.99 * kLeastStretch : 0.0)
                << "seed 71, round " << round;
        }
    }
}

TEST(InjectiveLimit, ScalesInverselyWithTheDrag) {
    const Vec3 by{0.0, 0.3, 2.0};
    const double t = injective_limit(brush_step(by).lattice_fields());
    ASSERT_LT(t, 1.0);
    EXPECT_NEAR(injective_limit(brush_step(2.0 * by).lattice_fields()), 0.5 * t, 1e-12);
    EXPECT_EQ(injective_limit(brush_step(0.999 * t * by).lattice_fields()), 1.0);
}

// Products that overflow prove nothing.
TEST(InjectiveLimit, IsZeroForValuesThatAreNotFinite) {
    const DragStep step = brush_step({0.0, 0.0, 1.0});
    const std::vector<LatticeField> fields = step.lattice_fields();
    const auto limit = [&](const Vec3& first, const Vec3& second) {
        std::vector<Vec3> displacements(fields.front().displacements().size(), Vec3{0.0});
        displacements[0] = first;
        displacements[1] = second;
        const std::array<LatticeField, 1> sum{{{step.field.lattice(), displacements}}};
        return injective_limit(sum);
    };
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_GT(limit({1e9, 0, 0}, {0, 1e9, 0}), 0.0);
    for (const double huge : {1e155, 1e300, infinity, std::nan("")}) {
        EXPECT_EQ(limit({huge, 0, 0}, {0, huge, 0}), 0.0) << huge;
        EXPECT_EQ(limit({huge, 0, 0}, {huge, 0, 0}), 0.0) << huge;
    }
    const auto solver = std::get<DragSolver>(DragSolver::create(
        step.field.lattice(), std::array{Handle{.prescribes_jacobian = true}}, {}));
    FoldGuard guard(solver);
    const std::array<HandleMotion, 1> motions{HandleMotion{Vec3{0.0}, Mat3{1e300}}};
    EXPECT_EQ(guard.limit(solver.step(motions)), 0.0);
}

TEST(GradientBounds, BoundTheGradientEverywhere) {
    LatticeRandom random(72);
    const DragStep step = brush_step({0.0, 0.0, 1.0});
    const double bound = gradient_bound(step.lattice_fields());
    double largest = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const Mat3 g =
            jacobian_at(step.lattice_fields(), random.vector(-kRadius, kRadius)) - Mat3{1.0};
        largest = std::max(largest, glm::length(Vec3{g[0].z, g[1].z, g[2].z}));
    }
    EXPECT_LE(largest, bound);
    EXPECT_GT(largest, 0.9 * bound);
}

// Follows a path like that of a hand. The guard agrees with the proof in every frame, also where it
// needs no new proof.
TEST(FoldGuard, AllowsExactlyWhatTheProofAllows) {
    test::Random random(77);
    for (int round = 0; round < test::case_count(20); ++round) {
        const Lattice lattice = brush_lattice(Vec3{0.0}, kRadius, 3);
        const std::vector<Handle> handles(1, Handle{.prescribes_jacobian = round % 2 == 1});
        const auto solver = std::get<DragSolver>(DragSolver::create(lattice, handles, {}));
        FoldGuard guard(solver);
        std::vector<HandleMotion> motions(1);
        for (int frame = 0; frame < 40; ++frame) {
            motions[0].displacement += 0.05 * random.direction() + Vec3{0.0, 0.02, 0.0};
            motions[0].jacobian = jacobian(Move{.twist = Twist{{1, 2, 3}, 0.5 * round * frame}});
            const DragStep step = solver.step(motions);
            EXPECT_EQ(guard.limit(step), injective_limit(step.lattice_fields()))
                << "seed 77, round " << round << ", frame " << frame;
        }
    }
}

// --- Steps

PlannedDrag planned(const DragPlan& plan) {
    auto result = plan_drag(plan);
    if (const auto* refusal = std::get_if<DragRefusal>(&result))
        throw std::runtime_error(refusal->what);
    return std::move(std::get<PlannedDrag>(result));
}

std::string refusal(const DragPlan& plan) {
    const auto result = plan_drag(plan);
    const auto* refused = std::get_if<DragRefusal>(&result);
    return refused ? refused->what : "";
}

DragPlan brush_plan(const Vec3& from, const Vec3& to, double radius = kRadius) {
    return {.moves = {{from, to}},
            .fold_free = true,
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

double least_determinant(const Warp& warp, int samples, test::Random& random) {
    double least = 1.0;
    for (const Deformation& step : warp.steps) {
        const auto fields = std::get<DragStep>(step).lattice_fields();
        for (const Box& zone : zones_of(step)) {
            for (int i = 0; i < samples; ++i) {
                const Vec3 at{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
                const Vec3 x = zone.min + at * zone.extent();
                least = std::min(least, glm::determinant(jacobian_at(fields, x)));
            }
        }
    }
    return least;
}

// A million points, spread over the steps of all directions.
TEST(FoldFreeDrag, FoldsNoSampleOfSpaceInAnyStepAndHitsItsTarget) {
    test::Random random(73);
    const int samples = test::case_count(1'000'000) / (26 * 8);
    const Vec3 from{0.0, 0.0, 1.0};
    for (const Vec3& direction : directions26()) {
        const Vec3 to = from + 3.0 * kRadius * direction;
        const PlannedDrag drag = planned(brush_plan(from, to));
        EXPECT_GE(drag.warp.steps.size(), 7u);
        EXPECT_LE(drag.warp.steps.size(), 9u);
        EXPECT_GT(least_determinant(drag.warp, samples, random), 0.9 * kLeastStretch);
        EXPECT_LT(glm::distance(warped(drag.warp, from), to), 1e-6);
    }
}

TEST(FoldFreeDrag, IsThePlainDragIfThatIsProven) {
    const Vec3 to{0.0, 0.0, 1.35};
    DragPlan plan = brush_plan({0, 0, 1}, to);
    const PlannedDrag free = planned(plan);
    plan.fold_free = false;
    const PlannedDrag plain = planned(plan);
    ASSERT_EQ(free.warp.steps.size(), 1u);
    EXPECT_EQ(std::get<DragStep>(free.warp.steps[0]).displacements,
              std::get<DragStep>(plain.warp.steps[0]).displacements);
    plan.moves[0].to = {0, 0, 3};
    EXPECT_EQ(planned(plan).warp.steps.size(), 1u);
}

TEST(FoldFreeDrag, HoldsItsPinsInEveryStep) {
    test::Random random(74);
    DragPlan plan = brush_plan({0, 0, 0}, {0, 0, 2.0});
    plan.pins = {{0.5, 0.1, 0.1}, {-0.3, 0.3, 1.0}, {5, 5, 5}};
    const PlannedDrag drag = planned(plan);
    EXPECT_GT(drag.warp.steps.size(), 5u);
    for (const Vec3& pin : plan.pins) EXPECT_LT(glm::distance(warped(drag.warp, pin), pin), 1e-6);
    EXPECT_LT(glm::distance(warped(drag.warp, {0, 0, 0}), Vec3(0, 0, 2)), 1e-6);
    EXPECT_GT(least_determinant(drag.warp, 2000, random), 0.0);
}

TEST(FoldFreeDrag, IsOneToOne) {
    test::Random random(75);
    const PlannedDrag drag = planned(brush_plan({0, 0, 1}, {0.7, 0.2, -1.2}));
    // The images of near points never coincide.
    for (int i = 0; i < 20000; ++i) {
        const Vec3 x{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.5, 2)};
        const Vec3 e = 1e-3 * random.direction();
        EXPECT_GT(glm::distance(warped(drag.warp, x), warped(drag.warp, x + e)), 1e-8);
    }
}

TEST(FoldFreeDrag, FollowsItsWaypoints) {
    DragPlan plan = brush_plan({0, 0, 0}, {1, 1, 0});
    plan.via = {{1, 0, 0}, {1, 0, 0}};
    const PlannedDrag drag = planned(plan);
    Vec3 at{0, 0, 0};
    bool passes = false;
    for (const Vec3& point : drag.points) {
        EXPECT_TRUE(point.y == 0.0 || point.x == 1.0);
        passes = passes || point == Vec3(1, 0, 0);
    }
    EXPECT_TRUE(passes);
    EXPECT_LT(glm::distance(warped(drag.warp, at), Vec3(1, 1, 0)), 1e-6);
    EXPECT_EQ(drag.points[drag.last_segment], Vec3(1, 0, 0));
}

TEST(FoldFreeDrag, RefusesTargetsThatNoOneToOneDeformationReaches) {
    DragPlan plan{.moves = {{{0.5, 0.5, 0.5}, {0.5, 0.5, 3.5}}},
                  .fold_free = true,
                  .lattice = {{0, 0, 0}, Vec3{0.5}, {3, 3, 3}}};
    EXPECT_NE(refusal(plan).find("take a target inside"), std::string::npos) << refusal(plan);
    plan.fold_free = false;
    EXPECT_EQ(refusal(plan), "");
    plan.fold_free = true;
    plan.moves[0].to = {0.5, 0.5, 1.2};
    EXPECT_EQ(refusal(plan), "");
    // The refusal names the target that is out of reach.
    DragPlan second = brush_plan({0, 0, 0}, {0, 0, 0});
    second.moves.push_back({{0.4, 0, 0}, {0.4, 0, 3.0}});
    EXPECT_NE(refusal(second).find("(0.4, 0, 3)"), std::string::npos) << refusal(second);
    // The refusal of a step in between names the target of the drag.
    DragPlan left_behind = brush_plan({0, 0, 0}, {0, 0, 3});
    left_behind.moves.push_back({{0.4, 0, 0}, {0.4, 0, 0}});
    EXPECT_NE(refusal(left_behind).find("on the way to (0, 0, 3)"), std::string::npos)
        << refusal(left_behind);
    DragPlan into_pin = brush_plan({0, 0, 0}, {0, 0, 1});
    into_pin.pins = {{0, 0, 0.5}};
    EXPECT_NE(refusal(into_pin), "");
}

TEST(FoldFreeDrag, RefusesTooManyWaypoints) {
    DragPlan plan = brush_plan({0, 0, 0}, {0, 0, 0.1});
    for (std::size_t i = 0; i < kMaxSteps; ++i)
        plan.via.push_back({0, 0.001 * double(i % 2 + 1), 0});
    for (const bool fold_free : {false, true}) {
        plan.fold_free = fold_free;
        EXPECT_NE(refusal(plan).find("fewer waypoints"), std::string::npos) << refusal(plan);
    }
    plan.via.pop_back();
    EXPECT_EQ(planned(plan).warp.steps.size(), kMaxSteps);
}

// --- Twist and scale

TEST(Move, HasFractionsWhoseJacobiansMultiplyToTheWhole) {
    const Move move{.twist = Twist{{1, 2, 3}, 200.0}, .scale = 1.7};
    const Mat3 third = jacobian(move, 1.0 / 3.0), whole = jacobian(move);
    const Mat3 product = third * third * third;
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(product[c] - whole[c]), 1e-12);
    EXPECT_NEAR(glm::determinant(whole), 1.7 * 1.7 * 1.7, 1e-12);
    EXPECT_LT(glm::length(whole * Vec3(1, 2, 3) - 1.7 * Vec3(1, 2, 3)), 1e-12);
    // By the right-hand rule about +z.
    const Mat3 quarter = jacobian(Move{.twist = Twist{{0, 0, 5}, 90.0}});
    EXPECT_LT(glm::length(quarter * Vec3(1, 0, 0) - Vec3(0, 1, 0)), 1e-15);
}

TEST(TwistedDrag, HasThePrescribedFrameAtThePoint) {
    test::Random random(76);
    for (int round = 0; round < test::case_count(40); ++round) {
        const Vec3 from = 2.0 * random.direction();
        DragPlan plan = brush_plan(from, from + random.uniform(0.0, 2.0) * random.direction());
        plan.fold_free = round % 2 == 0;
        plan.moves[0].twist = {random.direction(), random.uniform(-170.0, 170.0)};
        plan.moves[0].scale = random.scale(0.4, 2.5);
        const Warp warp = planned(plan).warp;
        Mat3 frame{1.0};
        Vec3 x = from;
        for (const Deformation& step : warp.steps) {
            const auto& drag = std::get<DragStep>(step);
            frame = jacobian_at(drag.lattice_fields(), x) * frame;
            x += drag.lattice_fields().front().displacement(x);
        }
        const Mat3 wanted = jacobian(plan.moves[0]);
        for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(frame[c] - wanted[c]), 1e-6);
        EXPECT_LT(glm::distance(x, plan.moves[0].to), 1e-6);
        // Finite differences of the images of points, which use float weights.
        for (int c = 0; c < 3; ++c) {
            Vec3 e{0.0};
            e[c] = 1e-3;
            const Vec3 column = (warped(warp, from + e) - warped(warp, from - e)) / 2e-3;
            EXPECT_LT(glm::length(column - wanted[c]), 2e-2);
        }
        if (!plan.fold_free) continue;
        EXPECT_GT(least_determinant(warp, 2000, random), 0.0);
    }
}

// The rotation of space at the point, summed over the steps.
double degrees_about_z(const Warp& warp, Vec3 x) {
    double sum = 0.0;
    for (const Deformation& step : warp.steps) {
        const auto fields = std::get<DragStep>(step).lattice_fields();
        const Vec3 image = jacobian_at(fields, x)[0];
        sum += std::atan2(image.y, image.x) * 180.0 / std::numbers::pi;
        x += fields.front().displacement(x);
    }
    return sum;
}

TEST(TwistedDrag, WithoutFoldsMakesTheFullRotation) {
    test::Random random(79);
    for (const double degrees : {30.0, 179.0, 300.0, 360.0, -340.0, 725.0}) {
        DragPlan plan = brush_plan({0, 0, 0}, {0.1, 0, 0});
        plan.moves[0].twist = {{0, 0, 1}, degrees};
        const Warp warp = planned(plan).warp;
        EXPECT_NEAR(degrees_about_z(warp, {0, 0, 0}), degrees, 1e-6);
        EXPECT_GT(least_determinant(warp, 1000, random), 0.0);
        // A single step determines only the orientation at its end.
        plan.fold_free = false;
        const double rest = std::remainder(degrees, 360.0);
        EXPECT_NEAR(degrees_about_z(planned(plan).warp, {0, 0, 0}), rest, 1e-6);
    }
}

TEST(TwistedDrag, AcceptsAnAxisOfAnyLengthAndRefusesExtremeRotations) {
    DragPlan plan = brush_plan({0, 0, 0}, {0, 0, 0.1});
    plan.fold_free = false;
    for (const double length : {1e-300, 1.0, 1e300}) {
        plan.moves[0].twist = {{0, 0, length}, 40.0};
        EXPECT_NEAR(degrees_about_z(planned(plan).warp, {0, 0, 0}), 40.0, 1e-6);
    }
    plan.moves[0].twist.reset();
    for (const double scale : {0.0, -1.0, 1e-4, 1001.0, 1e300}) {
        plan.moves[0].scale = scale;
        EXPECT_NE(refusal(plan).find("scale from 0.001 to 1000"), std::string::npos) << scale;
    }
    plan.moves[0].scale = 1.0;
    for (const double degrees : {3601.0, -1e300}) {
        plan.moves[0].twist = {{0, 0, 1}, degrees};
        EXPECT_NE(refusal(plan).find("3600 degrees"), std::string::npos) << degrees;
    }
}

TEST(TwistedDrag, IsRefusedWhereTheLatticeCannotRotate) {
    DragPlan plan = brush_plan({0, 0, 0}, {0, 0, 0});
    plan.lattice = brush_lattice({0, 0, 0}, 1.0, 1);
    plan.moves[0].twist = {{0, 0, 1}, 10.0};
    EXPECT_NE(refusal(plan).find("larger span"), std::string::npos) << refusal(plan);
    plan = brush_plan({0, 0, 0}, {0, 0, 0});
    plan.moves[0].twist = {{0, 0, 0}, 10.0};
    EXPECT_NE(refusal(plan).find("axis"), std::string::npos);
}

}  // namespace
}  // namespace pectin

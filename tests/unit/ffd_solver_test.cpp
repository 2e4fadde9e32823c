// Which drags the solver accepts, merges and refuses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ffd/drag_solver.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

const Lattice kCube{.origin = {0, 0, 0}, .cell = {1, 1, 1}, .deformable = {4, 4, 4}};

std::string refusal(const Lattice& lattice, const std::vector<Vec3>& moves,
                    const std::vector<Vec3>& pins = {}) {
    const auto solver = DragSolver::create(lattice, moves, pins);
    const auto* refused = std::get_if<DragRefusal>(&solver);
    return refused ? refused->what : "";
}

DragSolver solver_of(const Lattice& lattice, const std::vector<Vec3>& moves,
                     const std::vector<Vec3>& pins = {}) {
    return std::get<DragSolver>(DragSolver::create(lattice, moves, pins));
}

TEST(DragSolver, RefusesADragWithoutHandles) {
    EXPECT_NE(refusal(kCube, {}, {{1, 1, 1}}).find("at least one point"), std::string::npos);
}

TEST(DragSolver, RefusesALatticeWithoutExtent) {
    EXPECT_NE(refusal({.cell = {1, 0, 1}}, {{0, 0, 0}}).find("greater than 0"), std::string::npos);
    EXPECT_NE(refusal({.deformable = {0, 1, 1}}, {{0, 0, 0}}).find("1 to 256"), std::string::npos);
}

TEST(DragSolver, RefusesAHandleOutsideTheZoneOrOnItsBorderAndNamesBoth) {
    for (const Vec3& point : {Vec3{-2, 1, 1}, Vec3{1, 5, 1}, Vec3{1, 1, 7.25}}) {
        const std::string what = refusal(kCube, {{1, 1, 1}, point});
        EXPECT_NE(what.find("influenced zone (-2, -2, -2) to (5, 5, 5)"), std::string::npos);
    }
    EXPECT_NE(refusal(kCube, {{1, 1, 7.25}}).find("(1, 1, 7.25)"), std::string::npos);
    EXPECT_FALSE(refusal(kCube, {Vec3{std::nan(""), 0, 0}}).empty());
}

TEST(DragSolver, RefusesAHandleTooCloseToTheBorder) {
    EXPECT_NE(refusal(kCube, {{1, 1, -1.9}}).find("too close to the border"), std::string::npos);
    EXPECT_NE(refusal(kCube, {Vec3{-2.0 + 1e-9}}).find("too close"), std::string::npos);
    EXPECT_EQ(refusal(kCube, {{1, 1, -1.5}}), "");
    // The border of this lattice is the origin, where the basis of the nearest double underflows.
    const Lattice touching{.origin = {2, 2, 2}, .cell = {1, 1, 1}, .deformable = {2, 2, 2}};
    EXPECT_NE(refusal(touching, {{2, 2, 1e-300}}).find("too close"), std::string::npos);
}

TEST(DragSolver, NeverDisplacesControlPointsFartherThanItsLimit) {
    for (double inside = 0.01; inside < 1.0; inside += 0.01) {
        const Vec3 point{-2.0 + inside, 1.3, 1.4};
        const auto solver = DragSolver::create(kCube, {&point, 1}, {});
        if (!std::holds_alternative<DragSolver>(solver)) continue;
        const std::array<Vec3, 1> d{Vec3{1, 0, 0}};
        for (const Vec3& p : std::get<DragSolver>(solver).control_displacements(d)) {
            EXPECT_LE(glm::length(p), kMaxControlGain * (1.0 + 1e-12));
        }
    }
}

TEST(DragSolver, RefusesPointsTooCloseToTellApartAndNamesThem) {
    const std::string what = refusal(kCube, {{1, 1, 1}, {3, 2, 1}}, {{1, 1, 1.000001}});
    EXPECT_NE(what.find("(1, 1, 1) and (1, 1, 1.000001)"), std::string::npos) << what;
    EXPECT_EQ(refusal(kCube, {{1, 1, 1}}, {{1, 1, 1.01}}), "");
    EXPECT_NE(refusal(kCube, {{1, 1, 1}}, {{1, 2, 3}, {1, 2, 3.000001}}), "");
}

// On an axis with a single control point all points move in fixed proportions.
TEST(DragSolver, RefusesDistantPointsThatTheLatticeCannotMoveIndependently) {
    const Lattice slab{.deformable = {1, 4, 4}};
    const std::string what = refusal(slab, {{-0.5, 1, 1}}, {{0.5, 1, 1}, {0, 2, 2}});
    EXPECT_NE(what.find("cannot tell the moves and pins at (-0.5, 1, 1) and (0.5, 1, 1)"),
              std::string::npos)
        << what;
}

TEST(DragSolver, MeetsTheDragOfTheClosestPointsThatItAccepts) {
    const Vec3 move{1, 1, 1};
    int accepted = 0;
    for (double distance = 1e-6; distance < 0.1; distance *= 1.1) {
        const Vec3 pin{1, 1, 1 + distance};
        const auto solver = DragSolver::create(kCube, {&move, 1}, {&pin, 1});
        if (!std::holds_alternative<DragSolver>(solver)) continue;
        ++accepted;
        DragWeight at_move, at_pin;
        std::get<DragSolver>(solver).field().weights(move, {&at_move, 1});
        std::get<DragSolver>(solver).field().weights(pin, {&at_pin, 1});
        EXPECT_NEAR(at_move.w, 1.0f, 1e-6f) << distance;
        EXPECT_NEAR(at_pin.w, 0.0f, 1e-6f) << distance;
    }
    EXPECT_GT(accepted, 40);
}

TEST(DragSolver, RefusesMoreConstraintsThanControlPoints) {
    const Lattice single{.deformable = {1, 1, 1}};
    const std::string what = refusal(single, {{0, 0, 0}}, {{0.5, 0, 0}});
    EXPECT_NE(what.find("set 2 conditions, more than the 1 control point of the lattice"),
              std::string::npos);
    LatticeRandom random{23};
    SCOPED_TRACE("seed 23");
    std::vector<Vec3> many;
    for (std::size_t i = 0; i <= kMaxConstraints; ++i) many.push_back(random.vector(-1, 4));
    EXPECT_NE(refusal(kCube, {{1, 1, 1}}, many).find("at most 1024"), std::string::npos);
}

TEST(DragSolver, IgnoresPinsOutsideTheZone) {
    const std::vector<Vec3> outside{{9, 9, 9}, {-2, 1, 1}, {1, 1, 5}};
    const DragSolver with = solver_of(kCube, {{1, 1, 1}}, outside);
    const DragSolver without = solver_of(kCube, {{1, 1, 1}});
    const std::array<Vec3, 1> d{Vec3{1, 2, 3}};
    EXPECT_EQ(with.control_displacements(d), without.control_displacements(d));
    EXPECT_NE(refusal(kCube, {{1, 1, 1}}, {Vec3{0, INFINITY, 0}}).find("inf"), std::string::npos);
}

TEST(DragSolver, HoldsPinsNearTheBorderAsWellAsAnyOther) {
    const Vec3 pin{-1.9999, -1.9999, -1.9999};
    const DragSolver solver = solver_of(kCube, {{0, 0, 0}}, {pin});
    DragWeight weight;
    solver.field().weights(pin, {&weight, 1});
    EXPECT_NEAR(weight.w, 0.0f, 1e-15f);
    solver.field().weights({0, 0, 0}, {&weight, 1});
    EXPECT_EQ(weight.w, 1.0f);
}

TEST(DragSolver, CountsPinsAtOnePointOnce) {
    const DragSolver twice = solver_of(kCube, {{1, 1, 1}}, {{3, 1, 1}, {3, 1, 1}});
    const DragSolver once = solver_of(kCube, {{1, 1, 1}}, {{3, 1, 1}});
    const std::array<Vec3, 1> d{Vec3{1, 2, 3}};
    EXPECT_EQ(twice.control_displacements(d), once.control_displacements(d));
}

TEST(DragSolver, CountsHandlesAtOnePointOnceIfTheyAgree) {
    const std::vector<Vec3> moves{{1, 1, 1}, {1, 1, 1}, {3, 2, 1}};
    const DragSolver solver = solver_of(kCube, moves);
    const Vec3 d{0.1, 0.2, 0.3};
    const std::vector<Vec3> drags{d, d, {1, 0, 0}};
    EXPECT_EQ(solver.check(drags), std::nullopt);
    ASSERT_EQ(solver.field().weight_count(), 2u);
    const std::array<HandleMotion, 3> motions{HandleMotion{d}, HandleMotion{d},
                                              HandleMotion{drags[2]}};
    const std::vector<Vec3> asked = solver.field_displacements(motions);
    std::array<DragWeight, 2> weights;
    for (std::size_t m = 0; m < moves.size(); ++m) {
        solver.field().weights(moves[m], weights);
        EXPECT_LT(glm::length(displaced(moves[m], weights, asked) - moves[m] - drags[m]), 1e-7);
    }

    const auto refused = solver.check(std::vector<Vec3>{d, {0.1, 0.2, 0.4}, d});
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->what.find("(1, 1, 1)"), std::string::npos);
    EXPECT_NE(refused->what.find("by (0.1, 0.2, 0.3) and by (0.1, 0.2, 0.4)"), std::string::npos);
}

TEST(DragSolver, RefusesToMoveAPinnedPointUnlessByZero) {
    const DragSolver solver = solver_of(kCube, {{1, 1, 1}, {3, 2, 1}}, {{1, 1, 1}});
    EXPECT_EQ(solver.check(std::vector<Vec3>{Vec3{0.0}, {1, 0, 0}}), std::nullopt);
    const auto refused = solver.check(std::vector<Vec3>{{0, 0, 1e-9}, {1, 0, 0}});
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->what.find("(1, 1, 1) is pinned"), std::string::npos);
}

TEST(DragSolver, RefusesDisplacementsThatAreNotFinite) {
    const DragSolver solver = solver_of(kCube, {{1, 1, 1}});
    for (const double bad : {INFINITY, -INFINITY, NAN}) {
        EXPECT_TRUE(solver.check(std::vector<Vec3>{{0, bad, 0}}));
    }
    EXPECT_FALSE(solver.check(std::vector<Vec3>{{0, 1e9, 0}}));
}

}  // namespace
}  // namespace pectin

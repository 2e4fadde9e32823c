// The plateau: exactness, flatness and the proofs that rest on its coefficients.
#include "ffd/plateau.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "ffd/drag_plan.h"
#include "ffd/fold_guard.h"
#include "support/test_run.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

DragSolver plateau(const Lattice& lattice, const std::vector<Handle>& handles,
                   const std::vector<Vec3>& pins = {},
                   const std::optional<MirrorPlane>& plane = std::nullopt) {
    auto solved =
        DragSolver::create(lattice, handles, pins, plane, kMaxControlGain, Falloff::plateau);
    if (const auto* refusal = std::get_if<DragRefusal>(&solved)) {
        throw std::runtime_error(refusal->what);
    }
    return std::move(std::get<DragSolver>(solved));
}

// The brush's lattice around the origin with cells of size 1.
Lattice unit_brush(int span) { return brush_lattice(Vec3{0.0}, 0.5 * (span - 1) + 2.0, span); }

double weight(const DragField& field, const Vec3& x, std::size_t which = 0) {
    std::array<DragField::ExactWeight, 1> weight;
    field.exact_weights(x, which, weight);
    return weight[0].w;
}

std::vector<Handle> handles_of(const std::vector<Vec3>& points) {
    std::vector<Handle> handles;
    for (const Vec3& point : points) handles.push_back({point});
    return handles;
}

TEST(Plateau, MeetsEachHandleExactlyAndHoldsPins) {
    LatticeRandom random{71};
    SCOPED_TRACE("seed 71");
    for (int i = 0; i < test::case_count(60); ++i) {
        const Lattice lattice = random.lattice(Vec3{0.0}, 2, 8);
        std::vector<Vec3> points;
        random.add_points(lattice, random.count(2, 5), points);
        const std::size_t moved = static_cast<std::size_t>(random.count(1, 2));
        const std::vector<Vec3> handles(points.begin(), points.begin() + std::ptrdiff_t(moved));
        const std::vector<Vec3> pins(points.begin() + std::ptrdiff_t(moved), points.end());
        const auto solved = DragSolver::create(lattice, handles_of(handles), pins, std::nullopt,
                                               kMaxControlGain, Falloff::plateau);
        if (std::holds_alternative<DragRefusal>(solved)) continue;
        const DragField& field = std::get<DragSolver>(solved).field();
        for (std::size_t c = 0; c < moved; ++c) {
            for (std::size_t p = 0; p < points.size(); ++p) {
                EXPECT_NEAR(weight(field, points[p], c), c == p ? 1.0 : 0.0, 1e-9) << i;
            }
        }
    }
}

TEST(Plateau, PrescribesJacobiansExactlyAndRotatesTheMiddleAsAWhole) {
    const Lattice lattice = unit_brush(10);
    const Vec3 handle{0.1, -0.2, 0.05};
    const DragSolver solver = plateau(lattice, {{handle, true}});
    const Move twisted{.from = handle, .to = handle, .twist = Twist{{1, 2, 3}, 40.0}};
    const HandleMotion motion{{0.3, 0.1, -0.2}, jacobian(twisted)};
    const LatticeField field(
        lattice, solver.field().control_displacements(solver.field_displacements({&motion, 1})));
    EXPECT_LT(glm::distance(field.displacement(handle), motion.displacement), 1e-12);
    const Mat3 there = field.jacobian(handle);
    for (int column = 0; column < 3; ++column) {
        EXPECT_LT(glm::distance(there[column], motion.jacobian[column]), 1e-12);
    }
    // All control points that reach these points belong to the block.
    for (const Vec3& offset : {Vec3{0.3, 0.2, -0.1}, Vec3{-0.4, 0.4, 0.3}, Vec3{0.2, -0.2, 0.4}}) {
        const Vec3 expected = motion.displacement + (motion.jacobian - Mat3{1.0}) * offset;
        EXPECT_LT(glm::distance(field.displacement(handle + offset), expected), 1e-12);
    }
}

TEST(Plateau, IsFlatWhereAllControlPointsThatReachAPointBelongToTheBlock) {
    LatticeRandom random{72};
    SCOPED_TRACE("seed 72");
    const DragField field = plateau(unit_brush(8), {{Vec3{0.0}}}).field();
    for (int i = 0; i < 100; ++i) {
        std::array<DragField::ExactWeight, 1> there;
        field.exact_weights(random.vector(-0.5, 0.5), 0, there);
        EXPECT_NEAR(there[0].w, 1.0, 1e-12);
        EXPECT_LT(glm::length(there[0].gradient), 1e-12);
    }
    EXPECT_LT(weight(field, {4.0, 0, 0}), 0.9) << "and falls off beyond";
}

TEST(Plateau, WeightsAreThoseOfTheDisplacedControlPointsAndZeroOutsideTheZone) {
    LatticeRandom random{73};
    SCOPED_TRACE("seed 73");
    for (int span = 2; span <= 9; ++span) {
        const Lattice lattice = unit_brush(span);
        const DragSolver solver = plateau(lattice, {{Vec3{0.0}}}, {{0.9, 0.4, -0.3}});
        const std::array<Vec3, 1> d{Vec3{0.3, -1.0, 2.0}};
        const LatticeField moved(lattice, solver.control_displacements(d));
        for (int i = 0; i < 50; ++i) {
            const Vec3 x = random.point_in(lattice, 0.0);
            const Vec3 expected = moved.displacement(x);
            EXPECT_LT(glm::distance(weight(solver.field(), x) * d[0], expected), 1e-12);
            DragWeight rounded;
            solver.field().weights(x, {&rounded, 1});
            const double h = 1e-6;
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 ahead = x, behind = x;
                ahead[axis] += h;
                behind[axis] -= h;
                const double slope =
                    (weight(solver.field(), ahead) - weight(solver.field(), behind)) / (2.0 * h);
                EXPECT_NEAR(static_cast<double>(rounded.gradient[axis]), slope, 1e-5);
            }
        }
        DragWeight outside{1.0f, Vec3f{1.0f}};
        solver.field().weights(random.point_outside(lattice, 1.0), {&outside, 1});
        EXPECT_EQ(outside.w, 0.0f);
        EXPECT_EQ(outside.gradient, Vec3f{0.0f});
    }
}

// Half of the control points belong to each handle, so that all of them move alike.
TEST(Plateau, OfTwoHandlesThatMoveAlikeHasNoDentBetweenThem) {
    const DragSolver solver = plateau(unit_brush(11), {{{-1.3, 0, 0}}, {{1.3, 0, 0}}});
    for (double x = -1.3; x <= 1.3; x += 0.1) {
        const double sum =
            weight(solver.field(), {x, 0, 0}, 0) + weight(solver.field(), {x, 0, 0}, 1);
        EXPECT_NEAR(sum, 1.0, 1e-9) << x;
    }
    const auto sharp =
        DragSolver::create(unit_brush(9), handles_of({{-1.3, 0, 0}, {1.3, 0, 0}}), {});
    const DragField& peaks = std::get<DragSolver>(sharp).field();
    EXPECT_LT(weight(peaks, {0, 0, 0}, 0) + weight(peaks, {0, 0, 0}, 1), 0.8);
}

TEST(Plateau, ABoundHoldsForReachAndStretchEverywhere) {
    LatticeRandom random{74};
    SCOPED_TRACE("seed 74");
    for (int i = 0; i < test::case_count(40); ++i) {
        const Lattice lattice = unit_brush(random.count(2, 9));
        const DragField field = plateau(lattice, {{Vec3{0.0}}}, {{1.0, 0.6, 0.2}}).field();
        const std::array<Vec3, 1> d{random.vector(-2, 2)};
        for (int k = 0; k < 100; ++k) {
            DragWeight w;
            field.weights(random.point_in(lattice, 0.0), {&w, 1});
            EXPECT_LE(std::abs(w.w) * glm::length(d[0]), field.reach_bound(d) * (1 + 1e-6));
            EXPECT_LE(1.0 + glm::length(Vec3{w.gradient}) * glm::length(d[0]),
                      field.lipschitz_bound(d) * (1 + 1e-6));
        }
    }
}

// --- Symmetry

Vec3 displaced_by(const DragStep& step, const Vec3& x) {
    std::vector<DragWeight> weights(step.displacements.size());
    step.weights(x, weights);
    return displaced(x, weights, step.displacements);
}

TEST(Plateau, MeetsHandlesAndPinsOnBothSidesOfAPlaneAtAnyDistanceFromIt) {
    const MirrorPlane plane{.axis = 0, .at = 0.25};
    for (int span = 2; span <= 7; ++span) {
        for (const double offset : {-2.0, -0.7, -0.3, 0.0, 0.11, 0.5, 1.2, 4.0}) {
            const Vec3 handle{plane.at + offset, 0.3, -0.1};
            const Lattice lattice = brush_lattice(handle, 1.0, span);
            const Vec3 pin = handle + Vec3{0.2, 0.4, 0.3};
            const DragSolver solver = plateau(lattice, {{handle}}, {pin}, plane);
            Vec3 d{0.05, 0.4, -0.2};
            if (offset == 0.0) d.x = 0.0;
            const HandleMotion motion{d};
            ASSERT_FALSE(solver.check(std::span(&motion, 1))) << offset;
            const DragStep step = solver.step({&motion, 1});
            EXPECT_LT(glm::distance(displaced_by(step, handle), handle + d), 1e-6) << offset;
            EXPECT_LT(
                glm::distance(displaced_by(step, plane.image(handle)), plane.image(handle + d)),
                1e-6);
            EXPECT_LT(glm::distance(displaced_by(step, pin), pin), 1e-6) << span << ' ' << offset;
        }
    }
}

TEST(Plateau, TwistsBesideAndOnAPlaneAreMetExactly) {
    const MirrorPlane plane{.axis = 1, .at = -0.5};
    for (const double offset : {-1.0, -0.4, 0.0, 0.4, 1.0}) {
        const Vec3 handle{0.1, plane.at + offset, 0.2};
        const Move twisted{
            .from = handle, .to = handle, .twist = Twist{{0, 1, 0}, 30.0}, .scale = 1.2};
        Mat3 prescribed = jacobian(twisted);
        const DragSolver solver =
            plateau(brush_lattice(handle, 1.0, 5), {{handle, true}}, {}, plane);
        const HandleMotion motion{{0.1, 0.0, 0.2}, prescribed};
        if (solver.check(std::span(&motion, 1))) continue;
        const DragStep step = solver.step({&motion, 1});
        std::vector<DragWeight> weights(step.displacements.size());
        step.weights(handle, weights);
        const Mat3 there = jacobian(std::span<const DragWeight>(weights), step.displacements);
        for (int column = 0; column < 3; ++column) {
            EXPECT_LT(glm::distance(there[column], prescribed[column]), 1e-5) << offset;
        }
        EXPECT_LT(glm::distance(displaced_by(step, handle), handle + motion.displacement), 1e-6);
    }
}

TEST(Plateau, ABlockOnThePlaneMovesAsTheOneOfADragWithoutSymmetry) {
    const MirrorPlane plane{.axis = 2, .at = 0.0};
    const DragSolver with = plateau(unit_brush(5), {{Vec3{0.0}}}, {}, plane);
    const DragField without = plateau(unit_brush(5), {{Vec3{0.0}}}).field();
    const HandleMotion motion{{0.0, 1.0, 0.0}};
    const DragStep step = with.step({&motion, 1});
    LatticeRandom random{75};
    SCOPED_TRACE("seed 75");
    for (int i = 0; i < 200; ++i) {
        const Vec3 x = random.vector(-4.5, 4.5);
        EXPECT_NEAR(displaced_by(step, x).y - x.y, weight(without, x), 1e-6);
    }
}

TEST(Plateau, FarFromThePlaneEachSideMovesAsWithoutSymmetry) {
    LatticeRandom random{77};
    SCOPED_TRACE("seed 77");
    const MirrorPlane plane{.axis = 0, .at = 0.5};
    for (const double x : {-4.0, 4.0}) {
        const Vec3 handle{x, 0.3, 0.1};
        const Lattice lattice = brush_lattice(handle, 1.0, 4);
        const DragSolver with = plateau(lattice, {{handle, true}}, {}, plane);
        const DragSolver without = plateau(lattice, {{handle, true}});
        const Move twisted{.from = handle, .to = handle, .twist = Twist{{1, 2, 3}, 25.0}};
        const HandleMotion motion{{0.3, -0.2, 0.1}, jacobian(twisted)};
        const DragStep symmetric = with.step({&motion, 1}), plain = without.step({&motion, 1});
        for (int i = 0; i < 100; ++i) {
            const Vec3 point = random.point_in(lattice, 0.0);
            const Vec3 moved = displaced_by(plain, point);
            EXPECT_LT(glm::distance(displaced_by(symmetric, point), moved), 1e-6) << x;
            EXPECT_LT(
                glm::distance(displaced_by(symmetric, plane.image(point)), plane.image(moved)),
                1e-6);
        }
    }
}

// --- Folds

TEST(Plateau, StepsThatAreProvenNeverFold) {
    LatticeRandom random{76};
    SCOPED_TRACE("seed 76");
    int limited = 0;
    for (int i = 0; i < test::case_count(60); ++i) {
        const Lattice lattice = unit_brush(random.count(2, 7));
        const std::vector<Vec3> pins =
            random.count(0, 1) == 0 ? std::vector<Vec3>{} : std::vector{random.vector(0.5, 1.2)};
        const bool is_symmetric = random.count(0, 1) == 0;
        const std::optional<MirrorPlane> plane =
            is_symmetric ? std::optional(MirrorPlane{0, -random.between(0.3, 3.0)}) : std::nullopt;
        const DragSolver solver = plateau(lattice, {{Vec3{0.0}}}, pins, plane);
        const HandleMotion motion{random.vector(-3.0, 3.0)};
        DragStep step = solver.step({&motion, 1});
        const double t = proven_fraction(step);
        ASSERT_GT(t, 0.0);
        limited += t < 1.0 ? 1 : 0;
        for (Vec3& d : step.displacements) d *= t;
        std::vector<DragWeight> weights(step.displacements.size());
        for (int k = 0; k < 400; ++k) {
            step.weights(random.point_in(lattice, 0.0), weights);
            ASSERT_GT(
                jacobian_determinant(std::span<const DragWeight>(weights), step.displacements), 0.0)
                << i;
        }
    }
    EXPECT_GT(limited, test::case_count(60) / 6);
}

TEST(Plateau, AFoldFreePlanReachesItsTargetExactly) {
    const Vec3 from{0.2, 0.1, 0.0}, to{3.0, -1.0, 0.5};
    for (const bool fold_free : {false, true}) {
        const DragPlan plan{.moves = {{from, to}},
                            .fold_free = fold_free,
                            .lattice = brush_lattice(from, 1.0, 5),
                            .is_centred_on_point = true,
                            .falloff = Falloff::plateau};
        const auto planned = plan_drag(plan);
        ASSERT_TRUE(std::holds_alternative<PlannedDrag>(planned));
        const Warp& warp = std::get<PlannedDrag>(planned).warp;
        EXPECT_EQ(warp.steps.size() > 1, fold_free);
        Vec3 x = from;
        for (const Deformation& step : warp.steps) x = image(step, x);
        EXPECT_LT(glm::distance(x, to), 1e-5);
    }
}

}  // namespace
}  // namespace pectin

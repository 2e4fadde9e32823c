// Drags of many handles: handles and pins that repeat others share their weights, and a drag of
// many different handles becomes its displaced lattice.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "ffd/drag_plan.h"
#include "ffd/drag_solver.h"
#include "session/session.h"
#include "unit/ffd_random.h"

namespace pectin {
namespace {

const Lattice kLattice{.origin = Vec3{-1.0}, .cell = Vec3{0.4}, .deformable = {6, 6, 6}};

DragSolver solver_of(std::span<const Handle> handles, std::span<const Vec3> pins,
                     const std::optional<MirrorPlane>& plane = std::nullopt) {
    auto solved = DragSolver::create(kLattice, handles, pins, plane);
    if (const auto* refusal = std::get_if<DragRefusal>(&solved)) ADD_FAILURE() << refusal->what;
    return std::get<DragSolver>(std::move(solved));
}

TEST(RepeatedHandles, ShareTheirWeights) {
    const Handle handle{{0.1, 0.2, 0.3}, true}, other{{-0.5, 0.2, 0.3}};
    const std::vector<Vec3> pins(5000, Vec3{0.4, -0.4, 0.0});
    for (const auto& plane : {std::optional<MirrorPlane>{}, std::optional(MirrorPlane{0, 0.0})}) {
        const DragSolver once =
            solver_of(std::array{handle, other}, std::span(pins).first(1), plane);
        std::vector<Handle> handles{handle, other};
        std::vector<HandleMotion> motions{{{0.1, 0, 0}, Mat3{1.1}}, {{0, 0.1, 0}}};
        const std::vector<Vec3> expected = once.field_displacements(motions);
        for (int i = 0; i < 5000; ++i) {
            handles.push_back(i % 2 == 0 ? handle : other);
            motions.push_back(motions[static_cast<std::size_t>(i % 2)]);
        }
        const DragSolver many = solver_of(handles, pins, plane);
        EXPECT_EQ(many.field().weight_count(), once.field().weight_count());
        EXPECT_FALSE(many.check(motions));
        EXPECT_EQ(many.field_displacements(motions), expected);
    }
}

TEST(RepeatedHandles, MustAgreeAndArePinnedTogether) {
    const std::vector<Handle> handles(3, Handle{{0.1, 0.2, 0.3}});
    std::vector<HandleMotion> motions(3, HandleMotion{{0.1, 0, 0}});
    EXPECT_FALSE(solver_of(handles, {}).check(motions));
    motions[2].displacement.y = 0.1;
    EXPECT_TRUE(solver_of(handles, {}).check(motions));
    motions[2].displacement.y = 0.0;
    const auto refusal = solver_of(handles, std::array{Vec3{0.1, 0.2, 0.3}}).check(motions);
    ASSERT_TRUE(refusal);
    EXPECT_NE(refusal->what.find("is pinned"), std::string::npos);
}

TEST(RepeatedHandles, MustPrescribeTheSameJacobianAlsoIfTheFirstPrescribesNone) {
    const Vec3 point{0.1, 0.2, 0.3};
    const DragSolver solver =
        solver_of(std::array{Handle{point}, Handle{point, true}, Handle{point, true}}, {});
    std::array<HandleMotion, 3> motions;
    motions[1].jacobian = motions[2].jacobian = Mat3{1.1};
    EXPECT_FALSE(solver.check(motions));
    motions[2].jacobian = Mat3{0.9};
    EXPECT_TRUE(solver.check(motions));
}

TEST(DependentHandles, AreNamedOnceInTheRefusalIfTheyAreOnePoint) {
    // One control point cannot meet a displacement and a Jacobian.
    const Lattice small{.origin = Vec3{0.0}, .cell = Vec3{1.0}, .deformable = {1, 1, 1}};
    const auto solved =
        DragSolver::create(small, std::array{Handle{{0.5, 0.5, 0.5}, true}}, {}, std::nullopt);
    const auto* refusal = std::get_if<DragRefusal>(&solved);
    ASSERT_TRUE(refusal);
    const std::size_t first = refusal->what.find("(0.5, 0.5, 0.5)");
    ASSERT_NE(first, std::string::npos) << refusal->what;
    EXPECT_EQ(refusal->what.find("(0.5, 0.5, 0.5)", first + 1), std::string::npos) << refusal->what;
}

std::vector<Vec3> grid_of_points(int per_axis) {
    std::vector<Vec3> points;
    for (int i = 0; i < per_axis * per_axis * per_axis; ++i) {
        const Vec3 at(i % per_axis, i / per_axis % per_axis, i / (per_axis * per_axis));
        points.push_back(Vec3{-0.8} + 1.6 / (per_axis - 1) * at);
    }
    return points;
}

TEST(ManyHandles, BecomeTheirDisplacedLatticeWhichMovesSpaceAlike) {
    constexpr unsigned kSeed = 81;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    LatticeRandom random{kSeed};
    std::vector<Handle> handles;
    std::vector<HandleMotion> motions;
    for (const Vec3& point : grid_of_points(4)) {
        handles.push_back({point});
        motions.push_back({random.vector(-0.05, 0.05)});
    }
    // A cage that is symmetric about the plane is its own mirror image.
    for (const auto& plane : {std::optional<MirrorPlane>{}, std::optional(MirrorPlane{0, 0.0})}) {
        const std::size_t count = plane ? 2 : 64;
        const auto few = std::span(handles).first(count);
        const DragSolver solver = solver_of(few, {}, plane);
        const DragStep step = solver.step(std::span(motions).first(count));
        const Deformation same = compact(step);
        EXPECT_EQ(std::holds_alternative<LatticeField>(same), !plane) << "few moves stay a drag";
        for (int i = 0; i < 200; ++i) {
            const Vec3 x = random.point_in(kLattice, 0.0);
            std::vector<DragWeight> weights(step.displacements.size());
            step.weights(x, weights);
            Vec3 sum{0.0};
            for (const LatticeField& field : merged_lattices(same)) sum += field.displacement(x);
            EXPECT_LT(glm::distance(x + sum, displaced(x, weights, step.displacements)), 1e-6);
        }
    }
}

// A lattice that is not its own mirror image cannot stand for a symmetric drag alone.
TEST(ManySymmetricHandles, NeedNoWeightsAlsoIfTheLatticeIsNotItsMirrorImage) {
    constexpr unsigned kSeed = 82;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    LatticeRandom random{kSeed};
    const MirrorPlane plane{0, 0.0};
    Lattice lattice = kLattice;
    lattice.origin.x += 0.1;
    std::vector<Handle> handles;
    std::vector<HandleMotion> motions;
    for (const Vec3& point : grid_of_points(4)) {
        if (point.x < 0.0) continue;
        handles.push_back({point});
        motions.push_back({random.vector(-0.05, 0.05)});
    }
    const DragStep step =
        std::get<DragSolver>(DragSolver::create(lattice, handles, {}, plane)).step(motions);
    ASSERT_GT(weight_count(step), kMostWeights);
    const Deformation drag = compact(step);
    EXPECT_EQ(weight_count(drag), 0u);
    EXPECT_EQ(zones_of(drag), zones_of(step));
    for (int i = 0; i < 200; ++i) {
        Vec3 x = random.point_in(lattice, 0.0);
        std::vector<DragWeight> weights(step.displacements.size());
        step.weights(x, weights);
        EXPECT_LT(glm::distance(image(drag, x), displaced(x, weights, step.displacements)), 1e-6);
        EXPECT_EQ(image(drag, plane.image(x)), plane.image(image(drag, x)));
        EXPECT_EQ(jacobian(drag, plane.image(x)), plane.image_of_jacobian(jacobian(drag, x)));
        x = plane.onto(x);
        EXPECT_EQ(plane.onto(image(drag, x)), image(drag, x));
    }
}

// The drag also runs frame by frame and without folds, and is undone.
TEST(ManyHandles, ReachTheirTargetsHoweverTheyAreDragged) {
    for (const bool fold_free : {false, true}) {
        Session session;
        ASSERT_TRUE(session.execute(command::Shape{command::Shape::Kind::cube, 3}));
        ASSERT_TRUE(session.execute(command::Adapt{.enabled = false}));
        ASSERT_TRUE(session.execute(command::Cage{.fit = IVec3{6, 6, 6}}));
        const TriMesh before = session.mesh();
        std::vector<Vec3> points, targets;
        for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
            const Vec3 at = before.position(VertexId{v});
            points.push_back(at);
            targets.push_back(at + Vec3{0.1 * at.y, 0.05, 0.1 * at.x * at.z});
        }
        ASSERT_GT(points.size(), kMostWeights);
        ASSERT_TRUE(session.begin_drag(points, {}, {.fold_free = fold_free}));
        ASSERT_TRUE(session.drag_to(points));
        ASSERT_TRUE(session.drag_to(targets));
        const auto done = session.end_drag();
        ASSERT_TRUE(done);
        for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
            EXPECT_LT(glm::distance(session.mesh().position(VertexId{v}), targets[v]), 1e-9);
        }
        const TriMesh after = session.mesh();
        ASSERT_TRUE(session.execute(command::Undo{}));
        EXPECT_TRUE(session.mesh() == before);
        ASSERT_TRUE(session.execute(*done));
        EXPECT_TRUE(session.mesh() == after);
    }
}

TEST(ManySymmetricHandles, ReachTheirTargetsOnBothSidesHoweverTheyAreDragged) {
    for (const bool fold_free : {false, true}) {
        Session session;
        ASSERT_TRUE(session.execute(command::Shape{command::Shape::Kind::cube, 3}));
        ASSERT_TRUE(session.execute(command::Adapt{.enabled = false}));
        ASSERT_TRUE(session.execute(command::Symmetry{command::Symmetry::Plane::x}));
        ASSERT_TRUE(session.execute(command::Cage{
            .origin = Vec3{-1.3, -1.5, -1.5}, .cell = Vec3{0.4}, .deformable = IVec3{8}}));
        const TriMesh before = session.mesh();
        const auto target = [](const Vec3& at) {
            return at + Vec3{0.1 * at.x * at.y, 0.05, 0.1 * at.x * at.x * at.z};
        };
        std::vector<Vec3> points, targets;
        for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
            const Vec3 at = before.position(VertexId{v});
            if (at.x < 0.0) continue;
            points.push_back(at);
            targets.push_back(target(at));
        }
        ASSERT_GT(2 * points.size(), kMostWeights);
        ASSERT_TRUE(session.begin_drag(points, {}, {.fold_free = fold_free}));
        ASSERT_TRUE(session.drag_to(points));
        ASSERT_TRUE(session.drag_to(targets));
        const auto done = session.end_drag();
        ASSERT_TRUE(done);
        for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
            const Vec3 expected = target(before.position(VertexId{v}));
            EXPECT_LT(glm::distance(session.mesh().position(VertexId{v}), expected), 1e-9);
        }
        const TriMesh after = session.mesh();
        ASSERT_TRUE(session.execute(command::Undo{}));
        EXPECT_TRUE(session.mesh() == before);
        ASSERT_TRUE(session.execute(*done));
        EXPECT_TRUE(session.mesh() == after);
    }
}

}  // namespace
}  // namespace pectin

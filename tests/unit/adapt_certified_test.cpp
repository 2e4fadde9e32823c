// The certified trigger: a bar that is twisted, drags that do nothing, and the faces that are due.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "adapt/accumulated_error.h"
#include "adapt/adapt.h"
#include "adapt/due_faces.h"
#include "ffd/drag_plan.h"
#include "ffd/drag_solver.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "session/gesture.h"
#include "session/session.h"
#include "support/exact_surface.h"
#include "support/intersections_by_definition.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;
using Trigger = command::Adapt::Trigger;

// 1 x 1 x 10, of 12 triangles.
TriMesh bar() {
    IndexedFaceSet set = make_shape(ShapeKind::cube, 1);
    for (Vec3& p : set.positions) p *= Vec3{0.5, 0.5, 5.0};
    return build_mesh(set).mesh;
}

Warp half_turn_of_one_end() {
    const Vec3 end{0.0, 0.0, 5.0};
    const DragPlan plan{.moves = {{.from = end, .to = end, .twist = Twist{{0.0, 0.0, 1.0}, 180.0}}},
                        .pins = {-end},
                        .fold_free = true,
                        .lattice = brush_lattice(end, 14.0, 3),
                        .is_centred_on_point = true};
    return std::get<PlannedDrag>(plan_drag(plan)).warp;
}

TEST(CertifiedError, KeepsATwistedBarWithinItsToleranceAndUndoGivesItBack) {
    constexpr double kTolerance = 1e-2;  // 1e-3 of the length
    TriMesh mesh = bar();
    const TriMesh base = mesh;
    ASSERT_EQ(mesh.face_count(), 12u);
    const Warp warp = half_turn_of_one_end();
    const std::span<const Vec3> last = displacements_of(warp.steps.back());
    ActiveSet active(mesh);
    Gesture gesture(active, {.moving = test::live_faces(mesh)}, warp,
                    Gesture::Adaptivity{{.curvature = CertifiedError(kTolerance),
                                         .floor = 1e-4,
                                         .without_self_intersections = true}});
    const MeshChange change = gesture.commit(std::vector<Vec3>(last.begin(), last.end()));
    EXPECT_FALSE(gesture.last_frame().is_budget_used_up());
    EXPECT_LE(gesture.last_frame().error, kTolerance);
    EXPECT_EQ(gesture.last_frame().self_intersections, 0u);

    test::ExactImage image;
    image.add(warp);
    const TriMesh rest = test::on_original_surface(mesh, base);
    double farthest = 0.0;
    for (FaceId f : test::live_faces(mesh)) {
        farthest = std::max(farthest, test::sampled_error(image, test::corners_of(rest, f),
                                                          test::corners_of(mesh, f), 8));
    }
    EXPECT_LE(farthest, kTolerance);
    EXPECT_GT(farthest, 0.05 * kTolerance);
    std::printf("%u triangles in %zu steps, %.2g from the exact surface, %.2g allowed\n",
                mesh.face_count(), warp.steps.size(), farthest, kTolerance);

    undo(change, mesh);
    EXPECT_EQ(mesh.face_count(), 12u);
    EXPECT_TRUE(mesh == base);
}

// --- Sessions

Session sphere(const command::Adapt& adapt) {
    Session session;
    EXPECT_TRUE(session.execute(command::Shape{command::Shape::Kind::sphere, 3}));
    EXPECT_TRUE(session.execute(adapt));
    return session;
}

command::Drag drag(const Vec3& from, const Vec3& by) { return {.moves = {{from, from + by}}}; }

TEST(CertifiedError, IsReportedForTheLastDragAndForAllTogether) {
    Session session = sphere({.trigger = Trigger::certified});
    EXPECT_EQ(session.outcome().error.last, std::nullopt);
    EXPECT_EQ(session.outcome().error.total, 0.0);
    const double tolerance = 1e-3 * std::sqrt(12.0);
    double total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ASSERT_TRUE(session.execute(drag({0.0, 0.0, 1.0 + 0.2 * i}, {0.0, 0.0, 0.2})));
        const Statistics::Error error = session.outcome().error;
        ASSERT_TRUE(error.last && error.total);
        EXPECT_GT(*error.last, 0.1 * tolerance);
        EXPECT_LE(*error.last, tolerance * (1.0 + 1e-6));
        EXPECT_GT(*error.total, total);
        total = *error.total;
    }
    const Statistics::Error after = session.outcome().error;
    const TriMesh mesh = session.mesh();
    ASSERT_TRUE(session.execute(command::Undo{2}));
    EXPECT_LT(session.outcome().error.total, after.total);
    ASSERT_TRUE(session.execute(command::Redo{2}));
    EXPECT_EQ(session.outcome().error, after);
    EXPECT_TRUE(session.mesh() == mesh);
}

TEST(CertifiedError, IsUnknownAfterADragWithAnotherTriggerUntilThatIsUndone) {
    Session session = sphere({.trigger = Trigger::certified});
    ASSERT_TRUE(session.execute(drag({0.0, 0.0, 1.0}, {0.0, 0.0, 0.2})));
    const Statistics::Error known = session.outcome().error;
    ASSERT_TRUE(session.execute(command::Adapt{.trigger = Trigger::normals}));
    ASSERT_TRUE(session.execute(drag({0.0, 1.0, 0.0}, {0.0, 0.2, 0.0})));
    EXPECT_EQ(session.outcome().error, Statistics::Error{});
    ASSERT_TRUE(session.execute(command::Adapt{.trigger = Trigger::certified}));
    ASSERT_TRUE(session.execute(drag({1.0, 0.0, 0.0}, {0.2, 0.0, 0.0})));
    EXPECT_TRUE(session.outcome().error.last);
    EXPECT_FALSE(session.outcome().error.total);
    ASSERT_TRUE(session.execute(command::Undo{2}));
    EXPECT_EQ(session.outcome().error, known);
}

TEST(CertifiedError, SurvivesABakeAndItsUndo) {
    Session session = sphere({.trigger = Trigger::certified});
    ASSERT_TRUE(session.execute(drag({0.0, 0.0, 1.0}, {0.0, 0.0, 0.3})));
    const double total = largest_error(session.mesh());
    EXPECT_GT(total, 0.0);
    ASSERT_TRUE(session.execute(command::Bake{}));
    EXPECT_EQ(largest_error(session.mesh()), total);
    ASSERT_TRUE(session.execute(command::Undo{}));
    EXPECT_EQ(largest_error(session.mesh()), total);
}

// Each drag bends nothing, so no face exceeds the tolerance because of it. Without the errors of
// earlier drags each could remove some vertices of the first one.
TEST(CertifiedError, IsNotErodedByManyDragsThatDoNothing) {
    Session session = sphere({.trigger = Trigger::certified});
    ASSERT_TRUE(session.execute(drag({0.0, 0.0, 1.0}, {0.0, 0.0, 0.5})));
    const std::uint32_t faces = session.mesh().face_count();
    const double total = *session.outcome().error.total;
    for (int i = 0; i < 12; ++i) {
        ASSERT_TRUE(session.execute(drag({0.0, 0.0, 1.5}, {0.0, 0.0, 1e-9})));
    }
    EXPECT_GT(session.mesh().face_count(), faces * 9 / 10);
    EXPECT_LE(*session.outcome().error.total, std::max(total, 1e-3 * std::sqrt(12.0)) * 1.01);
}

// --- Faces that are due

// Frames of a drag, and the mesh after each of them.
std::vector<TriMesh> frames(CertifiedError::Search search, std::uint64_t seed) {
    Random random(seed);
    TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 3)).mesh;
    const std::vector<Vec3> grabbed{mesh.position(VertexId{5})};
    const auto solver = std::get<DragSolver>(
        DragSolver::create(brush_lattice(grabbed[0], random.scale(0.5, 2.0), 3), grabbed, {}));
    const Warp warp{{DragStep{solver.field(), {Vec3{0.0}}}}};
    ActiveSet active(mesh);
    Gesture gesture(
        active, {.moving = test::live_faces(mesh)}, warp,
        Gesture::Adaptivity{{.curvature = CertifiedError(5e-3, search), .floor = 1e-3}});
    std::vector<TriMesh> meshes;
    for (int i = 0; i < 8; ++i) {
        const Vec3 d = random.uniform(0.0, 0.6) * random.direction();
        gesture.frame(std::span(&d, 1));
        meshes.push_back(mesh);
    }
    return meshes;
}

TEST(DueFaces, GiveTheSameMeshesAsATestOfAllFaces) {
    const int cases = test::case_count(6);
    std::size_t refined = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 4600 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::vector<TriMesh> due = frames(CertifiedError::Search::due, seed),
                                   all = frames(CertifiedError::Search::all, seed);
        for (std::size_t k = 0; k < all.size(); ++k) {
            ASSERT_TRUE(due[k] == all[k]) << "frame " << k;
            if (all[k].face_count() > 1280) ++refined;
        }
    }
    EXPECT_GT(refined, static_cast<std::size_t>(cases));
}

std::vector<FaceId> due_by_definition(const ActiveSet& active, const InterpolationError& error,
                                      double tolerance) {
    std::vector<FaceId> due;
    for (FaceId f : test::live_faces(active.mesh())) {
        std::array<VertexId, 3> corners;
        for (int c = 0; c < 3; ++c) {
            corners[static_cast<std::size_t>(c)] = active.mesh().origin(TriMesh::half_edge(f, c));
        }
        std::ranges::sort(corners);  // as CertifiedError takes them
        const test::Corners rest{active.rest_position(corners[0]), active.rest_position(corners[1]),
                                 active.rest_position(corners[2])};
        if (error.bound(std::span(&rest, 1)) > tolerance) due.push_back(f);
    }
    return due;
}

TEST(DueFaces, AreThoseWhoseBoundIsAboveTheToleranceAmongEditsAndRollbacks) {
    const int cases = test::case_count(8);
    std::size_t found = 0;
    for (int i = 0; i < cases; ++i) {
        SCOPED_TRACE("seed " + std::to_string(4700 + i));
        Random random(4700 + static_cast<std::uint64_t>(i));
        TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 2)).mesh;
        const std::vector<Vec3> grabbed{mesh.position(VertexId{5})};
        const auto solver = std::get<DragSolver>(
            DragSolver::create(brush_lattice(grabbed[0], random.scale(0.4, 2.0), 3), grabbed, {}));
        Warp warp{{DragStep{solver.field(), {Vec3{0.0}}}}};
        ActiveSet active(mesh);
        active.begin(test::live_faces(mesh), warp.zone());
        InterpolationError error(warp);
        ASSERT_TRUE(error.is_proportional());
        DueFaces due;
        for (int frame = 0; frame < 12; ++frame) {
            displacements_of(warp.steps.back()).front() =
                random.uniform(0.0, 0.5) * random.direction();
            error.update();
            const double tolerance = 5e-3;
            const std::vector<FaceId> now = due.find(active, error, tolerance);
            ASSERT_EQ(now, due_by_definition(active, error, tolerance));
            found += now.size();
            if (random.chance(0.1)) active.roll_back();
            for (FaceId f : now) {
                if (mesh.is_live(f) && random.chance(0.3)) {
                    active.split(mesh.edge(TriMesh::half_edge(f, random.integer(0, 2))));
                }
            }
            for (VertexId v : std::vector(active.vertices().begin(), active.vertices().end())) {
                const auto star = exists(v) ? mesh.removable(v) : std::nullopt;
                if (star && random.chance(0.2)) active.unsplit(*star);
            }
        }
        active.cancel();
    }
    EXPECT_GT(found, 10u * static_cast<std::size_t>(cases));
}

}  // namespace
}  // namespace pectin

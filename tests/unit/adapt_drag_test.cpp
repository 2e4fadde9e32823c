// Drags of whole shapes: they are refined where they bend and nowhere else, and decimated again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "ffd/drag_solver.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Drag;
using command::Shape;

using test::expect_done;

// A cube with 8 x 8 quads on each side, dragged at the middle of its top.
Session dragged_cube(double by, double radius = 1.0, const Setting& l_max = Setting::off()) {
    Session session;
    expect_done(session, Shape{Shape::Kind::cube, 8});
    expect_done(session, Adapt{.theta_max = Setting::of(10.0), .l_max = l_max});
    expect_done(session, Brush{.radius = radius});
    expect_done(session, Drag{.moves = {{{0, 1, 0}, {0, 1.0 + by, 0}}}});
    return session;
}

TEST(DraggedCube, IsRefinedWhereItBendsAndNowhereForItsRightAngles) {
    const Session session = dragged_cube(0.2);
    const TriMesh& mesh = session.mesh();
    EXPECT_GT(session.statistics().last.splits, 50u);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    EXPECT_LE(session.statistics().divergence_max_deg, 10.001);
    for (std::uint32_t v = mesh.base_vertex_count(); v < mesh.vertex_slots(); ++v) {
        if (!mesh.is_live(VertexId{v})) continue;
        const Vec3& p = mesh.position(VertexId{v});
        EXPECT_GE(p.y, 1.0) << "not on the top";
        EXPECT_LT(std::max(std::abs(p.x), std::abs(p.z)), 1.0) << "on an edge of the cube";
        EXPECT_TRUE(mesh.is_deformed(VertexId{v}));
    }
}

TEST(DraggedCube, IsNotRefinedByADragTooSmallToBendIt) {
    const Session session = dragged_cube(1e-4);
    EXPECT_EQ(session.statistics().last.splits, 0u);
    EXPECT_EQ(session.mesh().face_count(), session.mesh().base_face_count());
    EXPECT_GT(session.statistics().divergence_max_deg, 0.0);
}

TEST(DraggedCube, IsNotRefinedWhereAHugeBrushMovesAllOfItButBendsNothing) {
    for (const Setting& l_max : {Setting::off(), Setting::automatic()}) {
        const Session session = dragged_cube(0.5, 200.0, l_max);
        const TriMesh& mesh = session.mesh();
        for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
            EXPECT_TRUE(mesh.is_deformed(VertexId{v}));  // also along the creases
        }
        EXPECT_EQ(session.statistics().last.splits, 0u);
    }
}

TEST(DraggedCube, KeepsItsCreasesWhereTheyBend) {
    // A brush around a corner bends three sides and the creases between them.
    Session session;
    expect_done(session, Shape{Shape::Kind::cube, 4});
    expect_done(session, Adapt{.theta_max = Setting::of(8.0), .l_max = Setting::off()});
    expect_done(session, Brush{.radius = 1.2});
    expect_done(session, Drag{.moves = {{{1, 1, 0}, {1.3, 1.1, 0.1}}}});
    const TriMesh& mesh = session.mesh();
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    int on_edge = 0;
    for (std::uint32_t v = mesh.base_vertex_count(); v < mesh.vertex_slots(); ++v) {
        const auto star = mesh.is_live(VertexId{v}) ? mesh.removable(VertexId{v}) : std::nullopt;
        if (!star || mesh.wedge(star->mc) == mesh.wedge(star->mb)) continue;
        ++on_edge;
        const float cosine =
            glm::dot(mesh.normal(mesh.wedge(star->mc)), mesh.normal(mesh.wedge(star->mb)));
        EXPECT_LT(std::abs(cosine), 0.6f) << "the crease is gone";
    }
    EXPECT_GT(on_edge, 0);
}

TEST(LMax, HoldsForEveryFaceThatMeetsTheZone) {
    for (std::uint64_t seed = 600; seed < 640; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        const Warp warp = test::random_warp(mesh, random);
        const Box zone = warp.zone();
        const double l_max =
            std::max(warp.smallest_feature_extent(), 0.05 * mesh.bounding_box().diagonal());
        ActiveSet active(mesh);
        active.begin(FaceTree(mesh).faces_meeting(zone, mesh), zone);
        Embedding embedding(active, warp);
        embedding.embed();
        embedding.deform();
        adapt(active, embedding, Criteria({.l_max = l_max}, zone, zone));
        for (FaceId f : test::live_faces(mesh)) {
            VertexId v[3];
            for (int c = 0; c < 3; ++c) v[c] = mesh.origin(TriMesh::half_edge(f, c));
            if (!triangle_meets_box(active.rest_position(v[0]), active.rest_position(v[1]),
                                    active.rest_position(v[2]), zone)) {
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                EXPECT_LE(glm::distance(mesh.position(v[c]), mesh.position(v[(c + 1) % 3])),
                          l_max * (1 + 1e-12));
            }
        }
        active.finish();
    }
}

// --- Floor and budget, frame by frame

NormalDivergence angles(double theta_max, double theta_min = kOff) {
    return NormalDivergence({.theta_max = theta_max, .theta_min = theta_min});
}

struct Frames {
    TriMesh mesh;
    ActiveSet active{mesh};
    std::unique_ptr<Gesture> gesture;

    Frames(const AdaptLimits& limits, double radius) {
        mesh = build_mesh(make_shape(ShapeKind::sphere, 3)).mesh;
        const std::vector<Vec3> points{{0, 1, 0}};
        auto solver = std::get<DragSolver>(
            DragSolver::create(brush_lattice(points[0], radius, 3), points, {}));
        Warp warp{{DragStep{solver.field(), std::vector<Vec3>(1)}}};
        const Box zone = warp.zone();
        const GestureFaces faces{.moving = FaceTree(mesh).faces_meeting(zone, mesh)};
        gesture =
            std::make_unique<Gesture>(active, faces, std::move(warp), Gesture::Adaptivity{limits});
    }
    Frame drag(const Vec3& by) { return gesture->frame(std::vector<Vec3>{by}); }
};

TEST(Budget, IsKeptAndReportedAndRestsUntilTheDragChanges) {
    Frames frames({.curvature = angles(0.5, 0.4), .floor = 1e-4, .budget = 2000}, 0.8);
    const Frame first = frames.drag({0, 0.3, 0});
    EXPECT_TRUE(first.budget_hit);
    EXPECT_LE(frames.mesh.face_count(), 2000u);
    EXPECT_GT(frames.mesh.face_count(), 1990u);
    const TriMesh after = frames.mesh;
    frames.drag({0, 0.3, 0});
    EXPECT_TRUE(frames.mesh == after);
    frames.drag({0, 0.3001, 0});
    EXPECT_FALSE(frames.mesh == after);
    EXPECT_LE(frames.mesh.face_count(), 2000u);
}

TEST(Budget, OfThePresentFaceCountAllowsNoSplit) {
    Frames frames({.curvature = angles(0.5, 0.4), .floor = 1e-4, .budget = 10}, 0.8);
    const Frame frame = frames.drag({0, 0.3, 0});
    EXPECT_TRUE(frame.budget_hit);
    EXPECT_EQ(frame.splits, 0u);
}

TEST(Floor, IsKeptAndReported) {
    Frames frames({.curvature = angles(0.5, 0.4), .floor = 0.02}, 0.8);
    const TriMesh before = frames.mesh;
    const Frame frame = frames.drag({0, 0.3, 0});
    EXPECT_TRUE(frame.floor_hit);
    EXPECT_FALSE(frame.budget_hit);
    EXPECT_GT(frame.splits, 0u);
    for (EdgeId e : test::live_edges(frames.mesh)) {
        // The halves are not shorter. The new edge may be, because it may be a height of the face.
        EXPECT_GE(frames.mesh.length(e), 0.5 * 0.02);
    }
    Frames coarse({.curvature = angles(0.5, 0.4), .floor = 1.0}, 0.8);
    EXPECT_TRUE(coarse.drag({0, 0.3, 0}).floor_hit);
    EXPECT_EQ(coarse.active.splits(), 0u);
}

// This holds even if the warp compresses edges that are long at rest and are therefore split first.
TEST(Floor, IsNeverCrossedByASplit) {
    int crushed = 0;
    for (std::uint64_t seed = 700; seed < 800; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        const Warp warp = test::random_warp(mesh, random);
        const Box zone = warp.zone();
        const double floor = mesh.bounding_box().diagonal() * random.scale(0.01, 0.05);
        ActiveSet active(mesh);
        active.begin(FaceTree(mesh).faces_meeting(zone, mesh), zone);
        Embedding embedding(active, warp);
        embedding.embed();
        embedding.deform();
        TriMesh replayed = mesh;
        const AdaptLimits limits{
            .curvature = NormalDivergence({.theta_max = random.scale(1.0, 20.0)}), .floor = floor};
        refine(active, embedding, Criteria(limits, zone, zone));
        for (const TopologyEdit& edit : active.finish().edits) {
            ASSERT_TRUE(edit.is_split());
            ASSERT_GE(replayed.length(edit.edge()), 2.0 * floor);
            const VertexId m = replayed.insert_midpoint(edit.edge()).m;
            replayed.set_position(m, mesh.position(m));
        }
        for (EdgeId e : test::live_edges(replayed)) {
            crushed += replayed.length(e) < 2.0 * floor ? 1 : 0;
        }
    }
    EXPECT_GT(crushed, 1000);
}

TEST(Gesture, DecimatesWhatEarlierFramesRefinedWhenTheDragReturns) {
    Frames frames({.curvature = angles(5.0, 4.0), .flatness = 0.02, .floor = 1e-3}, 0.8);
    const TriMesh before = frames.mesh;
    const Frame out = frames.drag({0, 0.4, 0});
    EXPECT_GT(out.splits, 100u);
    const Frame home = frames.drag(Vec3{0.0});
    EXPECT_GT(home.unsplits, out.splits / 2);
    frames.gesture->cancel();
    EXPECT_TRUE(frames.mesh == before);
}

TEST(Gesture, IsCancelledByItsDestructor) {
    Frames frames({.curvature = angles(5.0, 4.0), .floor = 1e-3}, 0.8);
    const TriMesh before = frames.mesh;
    frames.drag({0, 0.4, 0});
    EXPECT_FALSE(frames.mesh == before);
    frames.gesture.reset();
    EXPECT_TRUE(frames.mesh == before);
    EXPECT_FALSE(frames.active.is_begun());
}

}  // namespace
}  // namespace pectin

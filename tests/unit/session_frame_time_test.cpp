// Frames that end before adaptive meshing is done.
#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "session/session.h"
#include "support/mesh_figures.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Shape;

const Vec3 kTop{0, 0, 1};

// A sphere that a drag has to split thousands of times.
Session sphere() {
    Session session;
    EXPECT_TRUE(session.execute(Shape{Shape::Kind::sphere, 4}));
    EXPECT_TRUE(session.execute(Adapt{.theta_max = Setting::of(2.0)}));
    EXPECT_TRUE(session.execute(command::Brush{.radius = 0.9}));
    return session;
}

std::vector<Vec3> at(double height) { return {Vec3{0.1, 0, height}}; }

VertexId vertex_at_top(const TriMesh& mesh) {
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (glm::distance(mesh.position(VertexId{v}), kTop) < 1e-9) return VertexId{v};
    }
    return kNone<VertexId>;
}

// Without any time each frame does a little all the same.
TEST(FrameTime, StoppedFramesGoOnUntilNothingNeedsRefinement) {
    Session session = sphere();
    const VertexId top = vertex_at_top(session.mesh());
    session.set_frame_time(std::chrono::seconds(0));
    ASSERT_TRUE(session.begin_drag(std::vector{kTop}, {}));
    EXPECT_FALSE(session.continue_frame()) << "there is no frame yet";
    ASSERT_TRUE(session.drag_to(at(1.5)));
    EXPECT_FALSE(session.last_frame().is_complete);
    std::uint64_t splits = session.last_frame().splits;
    int frames = 1;
    while (session.continue_frame()) {
        EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
        EXPECT_LT(glm::distance(session.mesh().position(top), at(1.5)[0]), 1e-9);
        splits += session.last_frame().splits;
        ASSERT_LT(++frames, 10'000);
    }
    EXPECT_GT(frames, 5);
    EXPECT_GT(splits, 2000u);
    EXPECT_TRUE(session.last_frame().is_complete);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
}

// The vertices that are there follow the drag in every frame, so a frame without an end looks like
// the same drag on a mesh that is refined less.
TEST(FrameTime, StoppedFramesFollowTheDrag) {
    Session session = sphere();
    session.set_frame_time(std::chrono::seconds(0));
    ASSERT_TRUE(session.begin_drag(std::vector{kTop}, {}));
    const TriMesh before = session.mesh();
    for (const double height : {1.1, 1.4, 1.2, 1.6, 1.0}) {
        ASSERT_TRUE(session.drag_to(at(height)));
    }
    ASSERT_TRUE(session.drag_to(std::vector{kTop}));
    for (int frames = 0; session.continue_frame(); ++frames) ASSERT_LT(frames, 10'000);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
        EXPECT_EQ(session.mesh().position(VertexId{v}), before.position(VertexId{v}));
    }
    session.cancel_drag();
    EXPECT_TRUE(session.mesh() == before);
}

TEST(FrameTime, TheCommitDoesEverythingAndDependsOnNoFrame) {
    Session without = sphere(), with = sphere();
    with.set_frame_time(std::chrono::seconds(0));
    for (Session* session : {&without, &with}) {
        ASSERT_TRUE(session->begin_drag(std::vector{kTop}, {}, {.fold_free = true}));
        for (const double height : {1.05, 1.3, 1.5}) ASSERT_TRUE(session->drag_to(at(height)));
        EXPECT_EQ(session->has_unfinished_frame(), session == &with);
        ASSERT_TRUE(session->end_drag().has_value());
    }
    EXPECT_TRUE(with.mesh() == without.mesh());
    EXPECT_EQ(with.statistics().needing_refinement, 0u);
    EXPECT_GT(with.statistics().last.splits, 2000u);
}

// Decimation frees triangles, but what it frees is not used to refine again.
TEST(FrameTime, EndsAlsoWhereABudgetIsUsedUp) {
    for (const double first : {1.5, 1.9}) {
        Session session = sphere();
        ASSERT_TRUE(session.execute(Adapt{.drag_budget = Setting::of(6000)}));
        session.set_frame_time(std::chrono::seconds(0));
        ASSERT_TRUE(session.begin_drag(std::vector{kTop}, {}));
        for (const double height : {first, 1.6}) {
            ASSERT_TRUE(session.drag_to(at(height)));
            for (int frames = 0; session.continue_frame(); ++frames) ASSERT_LT(frames, 1000);
            EXPECT_TRUE(session.last_frame().drag_budget_hit);
        }
        const TriMesh before = session.mesh();
        ASSERT_TRUE(session.drag_to(at(1.6)));
        EXPECT_TRUE(session.mesh() == before) << "the drag has not changed";
    }
}

// The 1:512 rule and the floor leave edges that need refinement in every frame.
TEST(FrameTime, EndsAlsoWhereEdgesMayNotBeSplit) {
    Session session = sphere();
    ASSERT_TRUE(session.execute(Adapt{.floor = Setting::of(0.03)}));
    session.set_frame_time(std::chrono::seconds(0));
    ASSERT_TRUE(session.begin_drag(std::vector{kTop}, {}));
    ASSERT_TRUE(session.drag_to(at(0.2)));
    for (int frames = 0; session.continue_frame(); ++frames) ASSERT_LT(frames, 1000);
    EXPECT_TRUE(session.last_frame().floor_hit);
}

TEST(FrameTime, HoldsForControlPointsAndOnBothSidesOfAPlane) {
    for (const bool is_control : {false, true}) {
        Session session = sphere();
        ASSERT_TRUE(session.execute(command::Symmetry{.plane = command::Symmetry::Plane::x}));
        if (is_control) {
            ASSERT_TRUE(session.execute(command::Cage{.fit = IVec3{3, 3, 3}}));
        }
        session.set_frame_time(std::chrono::seconds(0));
        if (is_control) {
            ASSERT_TRUE(session.begin_control(std::vector{IVec3{2, 1, 1}}));
            ASSERT_TRUE(session.control_to(std::vector{Vec3{2.5, 0, 0}}));
        } else {
            ASSERT_TRUE(session.begin_drag(std::vector{Vec3{0.6, 0, 0.8}}, {}));
            ASSERT_TRUE(session.drag_to(std::vector{Vec3{0.8, 0, 1.2}}));
        }
        EXPECT_TRUE(session.has_unfinished_frame());
        int frames = 0;
        while (session.continue_frame()) ASSERT_LT(++frames, 10'000);
        EXPECT_GT(frames, 1);
        EXPECT_EQ(session.statistics().needing_refinement, 0u);
        EXPECT_LT(test::asymmetry(session.mesh()), 1e-6);
        session.cancel_drag();
        EXPECT_FALSE(session.has_unfinished_frame());
    }
}

TEST(FrameTime, FramesWithEnoughTimeAreComplete) {
    Session session = sphere();
    session.set_frame_time(std::chrono::hours(1));
    ASSERT_TRUE(session.begin_drag(std::vector{kTop}, {}));
    ASSERT_TRUE(session.drag_to(at(1.5)));
    EXPECT_TRUE(session.last_frame().is_complete);
    EXPECT_FALSE(session.continue_frame());
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
}

}  // namespace
}  // namespace pectin

// Commands and ends of drags that are asked to stop: the object is then as before, to the byte.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "session/gesture.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Drag;
using command::Readapt;
using test::expect_done;

const Vec3 kTop{0, 1, 0};

// What refines takes many batches at so small an angle.
Session sphere() {
    Session session;
    expect_done(session, command::Shape{command::Shape::Kind::sphere, 3});
    expect_done(session, command::Brush{.radius = 0.8});
    expect_done(session, Adapt{.theta_max = Setting::of(2.5)});
    return session;
}

Drag drag(bool fold_free) { return {.moves = {{kTop, Vec3{0, 1.5, 0}}}, .fold_free = fold_free}; }

// Asks to stop from the given question on.
StopToken from_question(int first) {
    return StopToken([count = 0, first]() mutable { return ++count >= first; });
}

TEST(StoppedSession, CancelsTheDragWhoseEndIsStopped) {
    for (const bool fold_free : {false, true}) {
        for (const int first : {1, 2, 3}) {
            Session session = sphere();
            const TriMesh before = session.mesh();
            ASSERT_TRUE(session.begin_drag(std::vector{kTop}, {}, {.fold_free = fold_free}));
            ASSERT_TRUE(session.drag_to(std::vector{Vec3{0, 1.5, 0}}));
            EXPECT_THROW(session.end_drag(from_question(first)), Stopped) << first;
            EXPECT_FALSE(session.is_dragging());
            EXPECT_TRUE(session.mesh() == before);
            EXPECT_EQ(session.undo_count(), 0u);
            // The token belongs to that call alone.
            expect_done(session, drag(fold_free));
            EXPECT_EQ(session.undo_count(), 1u);
        }
    }
}

TEST(StoppedSession, RestoresWhatACommandHasBegunToChange) {
    Session session = sphere();
    const TriMesh untouched = session.mesh();
    EXPECT_THROW(std::ignore = session.execute(drag(true), from_question(2)), Stopped);
    EXPECT_TRUE(session.mesh() == untouched);
    expect_done(session, drag(true));
    const TriMesh dragged = session.mesh();
    expect_done(session, Adapt{.theta_max = Setting::of(0.3)});
    EXPECT_THROW(std::ignore = session.execute(Readapt{}, from_question(1)), Stopped);
    EXPECT_TRUE(session.mesh() == dragged);
    EXPECT_THROW(std::ignore = session.execute(command::Bake{}, from_question(1)), Stopped);
    EXPECT_TRUE(session.mesh() == dragged);
    EXPECT_EQ(session.undo_count(), 1u);
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    expect_done(session, command::Undo{});
    EXPECT_TRUE(session.mesh() == untouched);
}

// Wherever redo is stopped, no step of several is left done.
TEST(StoppedSession, TakesBackTheStepsThatRedoHasDone) {
    Session session = sphere();
    const TriMesh untouched = session.mesh();
    expect_done(session, drag(false));
    expect_done(session, drag(true));
    const TriMesh dragged = session.mesh();
    expect_done(session, command::Undo{2});
    int questions = 0;  // in the first step
    EXPECT_TRUE(session.execute(command::Redo{1}, StopToken([&] { return ++questions, false; })));
    ASSERT_GT(questions, 0);
    expect_done(session, command::Undo{1});
    for (const int first : {1, questions + 1}) {
        EXPECT_THROW(std::ignore = session.execute(command::Redo{2}, from_question(first)),
                     Stopped);
        EXPECT_TRUE(session.mesh() == untouched) << first;
        EXPECT_EQ(session.redo_count(), 2u);
    }
    expect_done(session, command::Redo{2});
    EXPECT_TRUE(session.mesh() == dragged);
}

// A gesture of many steps is stopped while it is embedded, and another one can begin.
TEST(StoppedGesture, HasNotBegun) {
    TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 3)).mesh;
    const TriMesh untouched = mesh;
    const std::vector<FaceId> faces = test::live_faces(mesh);
    ActiveSet active(mesh);
    test::Random random(1);
    Warp warp;
    for (int step = 0; step < 5; ++step) {
        warp.steps.push_back(test::random_warp(mesh, random).steps.front());
    }
    for (int first = 1; first <= 5; ++first) {
        EXPECT_THROW(Gesture(active, {.moving = faces}, warp, std::nullopt, from_question(first)),
                     Stopped)
            << first;
        EXPECT_FALSE(active.is_begun());
        EXPECT_TRUE(mesh == untouched);
    }
    TriMesh other = untouched;
    ActiveSet fresh(other);
    const auto displacements = displacements_of(warp.steps.back());
    Gesture(active, {.moving = faces}, warp, std::nullopt).commit(displacements, {});
    Gesture(fresh, {.moving = faces}, warp, std::nullopt).commit(displacements, {});
    EXPECT_FALSE(mesh == untouched);
    EXPECT_TRUE(mesh == other);
}

TEST(StoppedBuild, ThrowsBetweenItsSteps) {
    const IndexedFaceSet sphere = make_shape(ShapeKind::sphere, 3);
    int questions = 0;
    const StopToken never([&] { return ++questions, false; });
    const TriMesh mesh = build_mesh(sphere, {}, never).mesh;
    EXPECT_GT(questions, 5);
    for (int first = 1; first <= questions; ++first) {
        EXPECT_THROW(build_mesh(sphere, {}, from_question(first)), Stopped) << first;
    }
}

TEST(StoppedBuild, OfAFaceTreeThrows) {
    const TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 6)).mesh;
    EXPECT_THROW(FaceTree(mesh, from_question(1)), Stopped);
    EXPECT_THROW(FaceTree(mesh, from_question(10)), Stopped);
}

}  // namespace
}  // namespace pectin

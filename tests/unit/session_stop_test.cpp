// Commands and ends of drags that are asked to stop: the object is then as before, to the byte.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "session/session.h"
#include "support/expect_done.h"

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
            ASSERT_FALSE(session.begin_drag(std::vector{kTop}, {}, {.fold_free = fold_free}));
            ASSERT_FALSE(session.drag_to(std::vector{Vec3{0, 1.5, 0}}));
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
    EXPECT_THROW(session.execute(drag(true), from_question(2)), Stopped);
    EXPECT_TRUE(session.mesh() == untouched);
    expect_done(session, drag(true));
    const TriMesh dragged = session.mesh();
    expect_done(session, Adapt{.theta_max = Setting::of(0.3)});
    EXPECT_THROW(session.execute(Readapt{}, from_question(1)), Stopped);
    EXPECT_TRUE(session.mesh() == dragged);
    EXPECT_THROW(session.execute(command::Bake{}, from_question(1)), Stopped);
    EXPECT_TRUE(session.mesh() == dragged);
    EXPECT_EQ(session.undo_count(), 1u);
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    expect_done(session, command::Undo{});
    EXPECT_TRUE(session.mesh() == untouched);
}

}  // namespace
}  // namespace pectin

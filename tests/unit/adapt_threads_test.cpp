// Passes over an active set are cut into pieces for all threads; what comes out may not tell.
#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <memory>
#include <variant>
#include <vector>

#include "ffd/drag_solver.h"
#include "session/session.h"

namespace pectin {
namespace {

// Frames and the commit of a drag that moves all of a sphere, splits and removes.
TriMesh dragged(int threads, bool has_two_moves) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    Session session;
    arena.execute([&] {
        EXPECT_FALSE(session.execute(command::Shape{command::Shape::Kind::sphere, 6}));
        EXPECT_FALSE(session.execute(command::Adapt{.theta_max = Setting::of(0.9)}));
        EXPECT_FALSE(session.execute(command::Brush{.radius = 4.0}));
        std::vector<Vec3> points{{0, 0, 1}}, targets{{0.3, 0.1, 1.5}};
        if (has_two_moves) points.push_back({0, 0, -1}), targets.push_back({0, 0, -1.4});
        EXPECT_FALSE(session.begin_drag(points, {}));
        EXPECT_FALSE(session.drag_to(targets));
        EXPECT_FALSE(session.drag_to(points));
        EXPECT_GT(session.last_frame().unsplits, 1000u);
        EXPECT_FALSE(session.drag_to(targets));
        EXPECT_GT(session.last_frame().splits, 1000u);
        EXPECT_TRUE(session.end_drag());
    });
    return session.mesh();
}

TEST(Threads, GiveTheSameBytesHoweverMany) {
    for (const bool has_two_moves : {false, true}) {
        const TriMesh one = dragged(1, has_two_moves);
        EXPECT_GT(one.vertex_count(), one.base_vertex_count() + 1000);
        EXPECT_TRUE(dragged(2, has_two_moves) == one);
        EXPECT_TRUE(dragged(8, has_two_moves) == one);
    }
}

}  // namespace
}  // namespace pectin

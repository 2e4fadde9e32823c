// Passes over an active set run on all threads; the result does not depend on their number.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "ffd/drag_solver.h"
#include "geometry/parallel.h"
#include "session/session.h"
#include "support/test_run.h"

namespace pectin {
namespace {

// Numbers of threads to compare with one.
std::vector<int> thread_counts() {
    return test::is_sanitized() ? std::vector{8} : std::vector{2, 8};
}

// Several frames and the commit of a drag that moves, refines and decimates all of a sphere.
TriMesh dragged(int threads, bool has_two_moves) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    Session session;
    arena.execute([&] {
        EXPECT_TRUE(session.execute(command::Shape{command::Shape::Kind::sphere, 6}));
        EXPECT_TRUE(session.execute(command::Adapt{.theta_max = Setting::of(0.9)}));
        EXPECT_TRUE(session.execute(command::Brush{.radius = 4.0}));
        std::vector<Vec3> points{{0, 0, 1}}, targets{{0.3, 0.1, 1.5}};
        if (has_two_moves) points.push_back({0, 0, -1}), targets.push_back({0, 0, -1.4});
        EXPECT_TRUE(session.begin_drag(points, {}));
        EXPECT_TRUE(session.drag_to(targets));
        EXPECT_TRUE(session.drag_to(points));
        EXPECT_GT(session.last_frame().unsplits, 1000u);
        EXPECT_TRUE(session.drag_to(targets));
        EXPECT_GT(session.last_frame().splits, 1000u);
        EXPECT_TRUE(session.end_drag());
    });
    return session.mesh();
}

// The same with control points of a cage. The smooth sphere takes one pass; the cube takes two,
// since its corners have several normals.
TriMesh moved_by_a_cage(int threads, command::Shape::Kind kind, int resolution) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    Session session;
    arena.execute([&] {
        EXPECT_TRUE(session.execute(command::Shape{kind, resolution}));
        EXPECT_TRUE(session.execute(command::Adapt{.theta_max = Setting::of(1.5)}));
        EXPECT_TRUE(session.execute(command::Cage{.fit = IVec3{4, 4, 4}}));
        const std::vector<IVec3> indices{{1, 1, 3}, {3, 2, 2}};
        const std::vector<Vec3> near{{-0.3, -0.3, 1.05}, {1.05, 0.3, 0.3}};
        const std::vector<Vec3> far{{-0.5, 0.2, 1.8}, {2.0, 0.3, -0.3}};
        EXPECT_TRUE(session.begin_control(indices));
        EXPECT_TRUE(session.control_to(far));
        EXPECT_TRUE(session.control_to(near));
        EXPECT_GT(session.last_frame().unsplits, 1000u);
        EXPECT_TRUE(session.control_to(far));
        EXPECT_GT(session.last_frame().splits, 1000u);
        EXPECT_TRUE(session.end_control());
    });
    return session.mesh();
}

TEST(Threads, DoNotChangeTheBytesOfAControlPointDrag) {
    for (const auto& [kind, resolution] :
         {std::pair{command::Shape::Kind::sphere, 6}, std::pair{command::Shape::Kind::cube, 80}}) {
        const TriMesh one = moved_by_a_cage(1, kind, resolution);
        EXPECT_GE(one.base_vertex_count(), 20000u);
        for (const int threads : thread_counts())
            EXPECT_TRUE(moved_by_a_cage(threads, kind, resolution) == one);
    }
}

TEST(Threads, DoNotChangeTheBytesOfADrag) {
    for (const bool has_two_moves : {false, true}) {
        const TriMesh one = dragged(1, has_two_moves);
        EXPECT_GT(one.vertex_count(), one.base_vertex_count() + 1000);
        for (const int threads : thread_counts())
            EXPECT_TRUE(dragged(threads, has_two_moves) == one);
    }
}

// The limit does not apply to the administrator, so another user is taken. It allows only the
// thread that exists.
void allow_no_further_thread() {
    if (geteuid() == 0 && setuid(65534) != 0) std::_Exit(2);
    const rlimit none{1, 1};
    if (setrlimit(RLIMIT_NPROC, &none) != 0) std::_Exit(2);
}

TEST(Threads, AreFewerWhereTheSystemAllowsNoMore) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            allow_no_further_thread();
            std::vector<std::uint8_t> done(1'000'000, 0);
            for_pieces(0, 1'000'000, [&](std::uint32_t first, std::uint32_t end) {
                for (std::uint32_t i = first; i < end; ++i) ++done[i];
            });
            const bool all = std::count(done.begin(), done.end(), 1) == 1'000'000;
            std::_Exit(all ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace pectin

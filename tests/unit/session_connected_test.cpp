// Connected drags: what is said if the part that moves passes through a part that stays.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using command::Brush;
using command::Drag;

const std::string kPasses = "passes through";

using test::expect_done;

class ConnectedSession : public testing::Test {
  protected:
    // Two grids of n by n quads with side 2, which face each other, at y = 0 and y = distance. A
    // fifth of the first one, where x < -0.6, lies at y = rise.
    Session sheets(int n, double distance, double rise = 0.0) const {
        std::string text;
        for (const bool is_upper : {false, true}) {
            for (int i = 0; i <= n; ++i) {
                for (int j = 0; j <= n; ++j) {
                    const double x = 2.0 * i / n - 1.0, z = 2.0 * j / n - 1.0;
                    const bool rises = !is_upper && x < -0.6;
                    text += "v " + std::to_string(x) + " " +
                            std::to_string(is_upper ? distance : (rises ? rise : 0.0)) + " " +
                            std::to_string(z) + "\n";
                }
            }
            const int first = 1 + (is_upper ? (n + 1) * (n + 1) : 0);
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const int a = first + i * (n + 1) + j, b = a + n + 1;
                    text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " +
                            std::to_string(b + 1) + " " + std::to_string(b) + "\n";
                }
            }
        }
        folder_.write("sheets.obj", text);
        Session session;
        expect_done(session, command::Open{.path = folder_.path("sheets.obj")});
        expect_done(session, Brush{.radius = 0.5});
        return session;
    }

    ScratchFolder folder_;
};

Drag upwards(double height, bool fold_free, bool connected = true) {
    return {.moves = {{Vec3{0.1, 0, 0.1}, Vec3{0.1, height, 0.1}}},
            .connected = connected,
            .fold_free = fold_free};
}

TEST_F(ConnectedSession, SaysThatThePartThatMovesPassesThroughOneThatStays) {
    for (const bool fold_free : {false, true}) {
        Session session = sheets(10, 0.3);
        expect_done(session, upwards(0.2, fold_free));
        EXPECT_EQ(session.remark(), "");
        EXPECT_EQ(test::crossings(session.mesh()), 0u);
        expect_done(session, upwards(0.6, fold_free));
        EXPECT_GT(test::crossings(session.mesh()), 0u);
        EXPECT_NE(session.remark().find(kPasses), std::string::npos) << session.remark();
        expect_done(session, command::Undo{});
        EXPECT_EQ(session.remark(), "");
        // Without `connected` the other sheet is moved as well.
        expect_done(session, upwards(0.6, true, false));
        EXPECT_EQ(session.remark(), "");
    }
}

TEST_F(ConnectedSession, SaysSoAlsoBeyondTheZoneOfADragThatFolds) {
    Session session = sheets(10, 0.9);
    expect_done(session, upwards(1.4, false));
    EXPECT_GT(test::crossings(session.mesh()), 0u);
    EXPECT_NE(session.remark().find(kPasses), std::string::npos) << session.remark();
    // The sheet would stay in any case.
    EXPECT_EQ(session.remark().find("switch connected off"), std::string::npos) << session.remark();
}

TEST_F(ConnectedSession, SaysSoIfAnEarlierStepWentFarther) {
    Session session = sheets(10, 0.9);
    Drag drag = upwards(1.35, false);
    drag.via = {Vec3{0.1, 1.3, 0.1}};
    expect_done(session, drag);
    EXPECT_GT(test::crossings(session.mesh()), 0u);
    EXPECT_NE(session.remark().find(kPasses), std::string::npos) << session.remark();
}

TEST_F(ConnectedSession, SaysSoWithoutRefinement) {
    Session session = sheets(10, 0.3);
    expect_done(session, command::Adapt{.enabled = false});
    expect_done(session, upwards(0.6, true));
    EXPECT_EQ(session.remark().find(kPasses) != std::string::npos,
              test::crossings(session.mesh()) > 0)
        << session.remark();
}

TEST_F(ConnectedSession, SaysSoWithTheMouse) {
    Session session = sheets(10, 0.3);
    ASSERT_TRUE(session.begin_drag(std::vector{Vec3{0.1, 0, 0.1}}, {},
                                   {.connected = true, .fold_free = true}));
    for (const double height : {0.2, 0.7, 0.5}) {
        ASSERT_TRUE(session.drag_to(std::vector{Vec3{0.1, height, 0.1}}));
    }
    session.end_drag();
    EXPECT_NE(session.remark().find(kPasses), std::string::npos) << session.remark();
}

TEST_F(ConnectedSession, SaysNothingOfPartsThatIntersectedBefore) {
    Session session = sheets(10, 0.3, 0.5);
    ASSERT_GT(test::crossings(session.mesh()), 0u);
    expect_done(session, Drag{.moves = {{Vec3{-0.6, 0.1, 0}, Vec3{-0.6, 0.13, 0}}},
                              .connected = true,
                              .fold_free = true});
    EXPECT_EQ(session.remark().find("stays"), std::string::npos) << session.remark();
}

// All pairs of triangles are tested here.
TEST_F(ConnectedSession, SpeaksIfAndOnlyIfTrianglesIntersect) {
    int silent = 0, spoken = 0;
    for (int seed = 1; seed <= test::case_count(48); ++seed) {
        test::Random random(static_cast<std::uint64_t>(seed));
        Session session = sheets(6 + seed % 5, random.uniform(0.15, 0.4));
        const Vec3 from{random.uniform(-0.5, 0.5), 0, random.uniform(-0.5, 0.5)};
        const Vec3 to = from + Vec3{random.uniform(-0.3, 0.3), random.uniform(0.1, 0.5),
                                    random.uniform(-0.3, 0.3)};
        expect_done(session,
                    Drag{.moves = {{from, to}}, .connected = true, .fold_free = seed % 2 == 0});
        if (session.statistics().folded_vertices > 0) continue;
        const bool intersects = test::crossings(session.mesh()) > 0;
        EXPECT_EQ(session.remark().find(kPasses) != std::string::npos, intersects)
            << "seed " << seed << ": " << session.remark();
        ++(intersects ? spoken : silent);
    }
    EXPECT_GT(silent, 0);
    EXPECT_GT(spoken, 0);
}

// Two long triangles share an edge outside the zone. Splitting the one that moves splits the other
// as well, at an edge whose middle is inside the zone.
TEST_F(ConnectedSession, LeavesMidpointsOfThePartThatStays) {
    folder_.write("wedge.obj", "v 0 0 0\nv 0 4 0\nv 2 2 0.1\nv 3 4.5 -0.1\nf 1 2 3\nf 2 1 4\n");
    for (const bool fold_free : {false, true}) {
        Session session;
        expect_done(session, command::Open{.path = folder_.path("wedge.obj")});
        expect_done(session, Brush{.radius = 1.5});
        expect_done(session, Drag{.moves = {{Vec3{2, 2, 0.1}, Vec3{2, 2, 0.6}}},
                                  .connected = true,
                                  .fold_free = fold_free});
        const TriMesh& mesh = session.mesh();
        int staying = 0, moved = 0;
        for (const FaceId f : test::live_faces(mesh)) {
            const bool stays = index(mesh.base_face(f)) == 1;
            for (int corner = 0; corner < 3; ++corner) {
                const Vec3& p = mesh.position(mesh.origin(TriMesh::half_edge(f, corner)));
                const double rest = stays ? -0.1 * p.x / 3.0 : 0.05 * p.x;
                if (!stays) {
                    moved += std::abs(p.z - rest) > 1e-3 ? 1 : 0;
                    continue;
                }
                EXPECT_NEAR(p.z, rest, 1e-12) << p.x << " " << p.y;
                ++staying;
            }
        }
        EXPECT_GT(staying, 3) << "the second triangle was split";
        EXPECT_GT(moved, 0);
        // Frames that were rolled back before leave no trace.
        Session by_hand;
        expect_done(by_hand, command::Open{.path = folder_.path("wedge.obj")});
        expect_done(by_hand, Brush{.radius = 1.5});
        ASSERT_TRUE(by_hand.begin_drag(std::vector<Vec3>{{2, 2, 0.1}}, {},
                                       {.connected = true, .fold_free = fold_free}));
        for (const double height : {0.5, 0.2, 0.6}) {
            ASSERT_TRUE(by_hand.drag_to(std::vector<Vec3>{{2, 2, height}}));
        }
        ASSERT_TRUE(by_hand.end_drag().has_value());
        EXPECT_TRUE(by_hand.mesh() == mesh);
        expect_done(session, command::Undo{});
        EXPECT_EQ(session.mesh().face_count(), 2u);
    }
}

}  // namespace
}  // namespace pectin

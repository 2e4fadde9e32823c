// Fold-free drags of an object: their targets, refinement and recorded commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <tuple>

#include "command/json.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Drag;
using command::Redo;
using command::Shape;
using command::Undo;

const Vec3 kFront{0, 0, 1};

using test::expect_done;

Session sphere(int resolution, double radius) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, resolution});
    expect_done(session, Brush{.radius = radius});
    return session;
}

Drag fold_free(const Vec3& to) { return {.moves = {{kFront, to}}, .fold_free = true}; }

VertexId vertex_at(const TriMesh& mesh, const Vec3& p) {
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (mesh.is_live(VertexId{v}) && mesh.position(VertexId{v}) == p) return VertexId{v};
    }
    return kNone<VertexId>;
}

std::vector<Vec3> directions26() {
    std::vector<Vec3> all;
    for (int i = 0; i < 27; ++i) {
        const Vec3 d{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        if (d != Vec3{0.0}) all.push_back(glm::normalize(d));
    }
    return all;
}

TEST(FoldFreeSession, FoldsNoVertexAndHitsItsTargetInAllDirections) {
    constexpr double kRadius = 0.4;
    Session session = sphere(4, kRadius);
    const VertexId grabbed = vertex_at(session.mesh(), kFront);
    for (const double radii : {1.0, 3.0}) {
        std::cout << radii << " radii, steps:";
        for (const Vec3& direction : directions26()) {
            const Vec3 to = kFront + radii * kRadius * direction;
            expect_done(session, fold_free(to));
            const Statistics statistics = session.statistics();
            EXPECT_EQ(statistics.folded_vertices, 0u);
            EXPECT_EQ(statistics.needing_refinement, 0u);
            EXPECT_LT(glm::distance(session.mesh().position(grabbed), to), 1e-5);
            EXPECT_GE(statistics.last.steps, radii == 1.0 ? 2u : 7u);
            std::cout << " " << statistics.last.steps;
            expect_done(session, Undo{});
        }
        std::cout << "\n";
    }
    // The plain drag folds.
    expect_done(session, Drag{.moves = {{kFront, {3.0 * kRadius, 0, 1}}}});
    EXPECT_GT(session.statistics().folded_vertices, 0u);
    EXPECT_EQ(session.statistics().last.steps, 1u);
}

TEST(FoldFreeSession, LeavesNoSelfIntersections) {
    for (const int resolution : {2, 3, 4}) {
        for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{0, 0, -0.6}, Vec3{1, 0, 0.3}}) {
            Session session = sphere(resolution, 0.5);
            const Vec3 to = kFront + 1.5 * direction;
            expect_done(session, fold_free(to));
            EXPECT_EQ(session.statistics().folded_vertices, 0u);
            EXPECT_EQ(test::crossings(session.mesh()), 0u) << resolution;
        }
    }
}

// The cap of a cylinder, a fan of large flat triangles, is pulled sideways and back. It is nearly
// flat at the end, so it follows the deformation only if it is refined because of the steps in
// between.
TEST(FoldFreeSession, DoesNotIntersectTrianglesThatWereLongBetweenItsSteps) {
    for (const double radius : {0.65, 0.8}) {
        Session session;
        expect_done(session, Shape{Shape::Kind::cylinder, 8});
        expect_done(session, Brush{.radius = radius});
        const Vec3 from{0, 1, 0};
        for (int i = 0; i < 16; ++i) {
            const double angle = (i < 8 ? 0.1 : 0.4) + 0.25 * std::numbers::pi * i;
            expect_done(
                session,
                Drag{.moves = {{from, {0, 0.97, 0}}},
                     .fold_free = true,
                     .via = {from + 2.0 * radius * Vec3{std::cos(angle), 0, std::sin(angle)}}});
            EXPECT_EQ(test::crossings(session.mesh()), 0u) << radius << ", " << angle;
            expect_done(session, Undo{});
        }
    }
}

// The path leads outwards and returns another way, so edges are longer between the steps than at
// the end.
TEST(FoldFreeSession, RefinesEdgesThatAreLongBetweenItsSteps) {
    Session session = sphere(2, 0.6);
    expect_done(session, Adapt{.theta_max = Setting::off(), .flatness = Setting::off()});
    Drag drag = fold_free({0, 0, 1.01});
    drag.via = {{0, 0, 2.2}};
    expect_done(session, drag);
    const std::uint64_t with_steps = session.statistics().faces;
    expect_done(session, Undo{});
    expect_done(session, fold_free({0, 0, 1.01}));
    EXPECT_GT(with_steps, session.statistics().faces);
    expect_done(session, Undo{});
    expect_done(session, drag);
    EXPECT_EQ(test::crossings(session.mesh()), 0u);
}

// Drags like those of a hand, which bring sheets of the surface close to each other.
Drag wandering_drag(test::Random& random, int waypoints, bool goes_home) {
    Drag drag = fold_free(kFront);
    for (int i = 0; i < waypoints; ++i) {
        drag.via.push_back((i == 0 ? kFront : drag.via.back()) +
                           (i == 0 ? 1.2 : 1.0) * random.direction());
    }
    drag.moves.front().to =
        goes_home ? kFront + 0.05 * random.direction() : drag.via.back() + random.direction();
    return drag;
}

// With refinement by angle and length alone most of these drags end with self-intersections.
TEST(FoldFreeSession, LeavesNoSelfIntersectionsAfterAWanderingDrag) {
    const std::uint64_t count = static_cast<std::uint64_t>(test::case_count(4));
    for (const int waypoints : {0, 1, 2}) {
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            test::Random random(seed);
            Session session = sphere(2 + static_cast<int>(seed % 3), 0.4 + 0.1 * double(seed % 4));
            // Less than the distance between any two sheets here.
            expect_done(session, Adapt{.floor = Setting::of(1e-6)});
            expect_done(session, wandering_drag(random, std::max(1, waypoints), waypoints == 0));
            const Statistics statistics = session.statistics();
            EXPECT_EQ(test::crossings(session.mesh()), 0u) << waypoints << ", seed " << seed;
            EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
            EXPECT_EQ(statistics.needing_refinement, 0u) << waypoints << ", seed " << seed;
            EXPECT_FALSE(statistics.floor_hit);
            // A readapt changes nothing.
            expect_done(session, command::Readapt{});
            EXPECT_EQ(session.statistics().last.splits, 0u) << waypoints << ", seed " << seed;
            EXPECT_EQ(test::crossings(session.mesh()), 0u) << waypoints << ", seed " << seed;
        }
    }
}

TEST(FoldFreeSession, ReportsSelfIntersectionsThatTheFloorLeaves) {
    test::Random random(4);
    Session session = sphere(3, 0.4);
    expect_done(session, Adapt{.floor = Setting::of(0.05)});
    expect_done(session, wandering_drag(random, 2, false));
    EXPECT_GT(test::crossings(session.mesh()), 0u);
    EXPECT_NE(session.remark().find("the surface intersects itself in"), std::string::npos)
        << session.remark();
    EXPECT_TRUE(session.statistics().floor_hit);
    // They are also reported at the budget, and without a flatness limit.
    expect_done(session, Undo{});
    expect_done(session, Adapt{.floor = Setting::automatic(), .budget = 1300});
    expect_done(session, wandering_drag(random, 2, false));
    EXPECT_EQ(session.remark().empty(), test::crossings(session.mesh()) == 0);
    expect_done(session, Undo{});
    expect_done(session, Adapt{.theta_max = Setting::off(), .budget = 4'000'000});
    expect_done(session, wandering_drag(random, 2, false));
    EXPECT_EQ(session.remark().empty(), test::crossings(session.mesh()) == 0);
}

TEST(FoldFreeSession, RecordsWaypointsSoThatAScriptGivesTheSameBytes) {
    test::Random random(91);
    for (int round = 0; round < test::case_count(10); ++round) {
        const bool is_cage = round % 4 == 3;
        Session hand = sphere(3, 0.4), script = sphere(3, 0.4);
        if (is_cage) {
            for (Session* session : {&hand, &script}) {
                expect_done(*session, command::Cage{.fit = IVec3{4, 4, 4}});
            }
        }
        for (Session* session :
             {&hand, &script}) {  // the test is about bytes, not about refinement
            expect_done(*session, Adapt{.floor = Setting::of(0.01)});
        }
        const TriMesh before = hand.mesh();
        const std::vector<Vec3> pins{{0.2, 0, 0.95}};
        ASSERT_TRUE(hand.begin_drag(
            std::vector{kFront}, round % 2 == 0 ? std::vector<Vec3>{} : pins, {.fold_free = true}));
        Vec3 at = kFront;
        // Near the border of a cage everything is pressed flat, so the path is shorter.
        const double speed = is_cage ? 0.1 : 1.0;
        const Vec3 velocity = 0.06 * speed * random.direction();
        for (int frame = 0; frame < 25; ++frame) {
            at += velocity + 0.05 * speed * random.direction();
            if (frame == 12 && !is_cage) at += 0.8 * random.direction();  // the mouse jumps
            std::ignore = hand.drag_to(std::vector{at});
            EXPECT_EQ(hand.mesh().validate(), std::vector<std::string>{});
            if (frame == 20) {
                const Move rotated{kFront, at, Twist{{0, 0, 1}, 15.0}, 1.1};
                std::ignore = hand.drag_to(std::span(&rotated, 1));
            }
        }
        const auto drag = hand.end_drag();
        ASSERT_TRUE(drag.has_value());
        if (!is_cage) {
            EXPECT_FALSE(drag->via.empty());
        }
        const auto read = parse_command(format_command(*drag));
        expect_done(script, std::get<Command>(read));
        EXPECT_TRUE(hand.mesh() == script.mesh()) << "seed 91, round " << round;
        EXPECT_EQ(hand.statistics().folded_vertices, 0u);
        expect_done(hand, Undo{});
        EXPECT_TRUE(hand.mesh() == before);
        expect_done(hand, Redo{});
        EXPECT_TRUE(hand.mesh() == script.mesh());
    }
}

TEST(FoldFreeSession, RestoresEverythingWhenALongDragIsCancelled) {
    Session session = sphere(3, 0.4);
    const TriMesh before = session.mesh();
    ASSERT_TRUE(session.begin_drag(std::vector{kFront}, {}, {.fold_free = true}));
    for (double z = 1.0; z < 2.5; z += 0.1) {
        ASSERT_TRUE(session.drag_to(std::vector<Vec3>{{0, 0, z}}));
    }
    EXPECT_GT(session.active_drag().via.size(), 3u);
    session.cancel_drag();
    EXPECT_TRUE(session.mesh() == before);
    expect_done(session, fold_free({0, 0, 1.3}));
}

// Along the border of a cage every step shears the surface again.
TEST(FoldFreeSession, RefusesTheBorderOfACageBeforeRefinementBecomesEndless) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        test::Random random(seed);
        Session session = sphere(3, 0.4);
        const command::Cage cage{
            .origin = Vec3{-1.0}, .cell = Vec3{2.0 / 3.0}, .deformable = IVec3{4}};
        expect_done(session, command::Cage{cage});
        ASSERT_TRUE(session.begin_drag(std::vector{kFront}, {}, {.fold_free = true}));
        Vec3 at = kFront, velocity = 0.06 * random.direction();
        std::string refused;
        for (int frame = 0; frame < 60; ++frame) {
            at += velocity + 0.05 * random.direction();
            if (glm::length(at) > 4.0) velocity = -velocity;
            const Done done = session.drag_to(std::vector{at});
            if (!done &&
                done.refusal().reason.find("too close to the border") != std::string::npos) {
                refused = done.refusal().reason;
            }
        }
        if (seed != 2) {  // whose path stays away from the border
            EXPECT_NE(refused.find("100 times"), std::string::npos) << "seed " << seed;
        }
        session.end_drag();
        EXPECT_LT(session.statistics().faces, 40'000u) << "seed " << seed;
        EXPECT_EQ(session.statistics().folded_vertices, 0u);
    }
}

TEST(FoldFreeSession, KeepsTheFrameIfTheNextIsRefused) {
    Session session = sphere(3, 0.4);
    expect_done(session, command::Cage{.fit = IVec3{4, 4, 4}});
    ASSERT_TRUE(session.begin_drag(std::vector{kFront}, {}, {.fold_free = true}));
    ASSERT_TRUE(session.drag_to(std::vector<Vec3>{{0, 0, 1.5}}));
    const TriMesh before = session.mesh();
    const Done done = session.drag_to(std::vector<Vec3>{{0, 0, 4}});
    ASSERT_FALSE(done);
    EXPECT_NE(done.refusal().reason.find("take a target inside"), std::string::npos);
    EXPECT_TRUE(session.mesh() == before);
    ASSERT_TRUE(session.drag_to(std::vector<Vec3>{{0, 0, 1.4}}));
    EXPECT_TRUE(session.end_drag().has_value());
}

}  // namespace
}  // namespace pectin

// The midpoint trigger by itself: on two triangles, and its settings.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "adapt/criteria.h"
#include "adapt/decimate.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"

namespace pectin {
namespace {

using test::edge_between;
using test::mesh_of;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n";
const Box kEverywhere{.min = Vec3{-9.0}, .max = Vec3{9.0}};

AdaptLimits limits_of(double tolerance) { return {.curvature = MidpointDistance(tolerance)}; }

// A square of two triangles in a gesture that takes the middles of edges nowhere, and whose corners
// the tests move.
class Square {
  public:
    Square() { active.begin(std::vector<FaceId>{FaceId{0}, FaceId{1}}, kEverywhere); }
    ~Square() { active.cancel(); }
    Square(const Square&) = delete;
    Square& operator=(const Square&) = delete;

    void move(std::uint32_t v, const Vec3& to) {
        mesh.set_position(VertexId{v}, to);
        mesh.set_deformed(VertexId{v}, true);
    }
    // Expects that the error of the edge between these vertices is this.
    void expect_error(std::uint32_t b, std::uint32_t c, double error) const {
        const EdgeId e = edge_between(mesh, b, c);
        const auto needs = [&](double tolerance) {
            return Criteria(limits_of(tolerance), std::nullopt, std::nullopt)
                .needs_refinement(active, e);
        };
        EXPECT_TRUE(needs(0.9999 * error));
        EXPECT_FALSE(needs(1.0001 * error));
    }

    TriMesh mesh = mesh_of(kSquare);
    ActiveSet active{mesh};
};

TEST(MidpointDistance, AddsTheDistancesFromThePlanesOfBothFaces) {
    Square square;
    const double h = 0.3;
    square.move(1, {1.0, 0.0, h});
    // delta is (0, 0, -h/2), and the normals are (-h, 0, 1) and (0, h, 1).
    square.expect_error(1, 2, h / std::sqrt(1.0 + h * h));
}

TEST(MidpointDistance, DoesNotCountWhatMovesAlongBothFaces) {
    Square square;
    square.move(1, {1.3, -0.2, 0.0});
    EXPECT_FALSE(Criteria(limits_of(1e-9), std::nullopt, std::nullopt)
                     .needs_refinement(square.active, edge_between(square.mesh, 1, 2)));
}

TEST(MidpointDistance, IsTheDistanceFromTheLineAtABoundary) {
    Square square;
    square.move(1, {1.0, -0.2, 0.0});
    square.expect_error(0, 1, 0.1 / std::sqrt(1.04));
    square.move(1, {1.0, 0.0, 0.3});
    square.expect_error(0, 1, 0.15 / std::sqrt(1.09));
}

TEST(MidpointDistance, CountsAllOfDeltaBesideAFaceWithoutArea) {
    Square square;
    square.move(0, {0.5, 0.5, 0.0});
    square.move(1, {1.0, 0.0, 0.4});
    square.move(0, {0.5, 0.5, 0.2});  // in the middle of the edge from 1 to 2
    const double h = 0.4;
    square.expect_error(1, 2, 0.5 * h + 0.5 * h / std::sqrt(1.0 + h * h));
}

TEST(MidpointDistance, IsNotAskedWhereNoEndIsDeformed) {
    Square square;
    square.mesh.set_position(VertexId{1}, {1.0, 0.0, 0.3});
    const EdgeId e = edge_between(square.mesh, 1, 2);
    const Criteria criteria(limits_of(1e-3), std::nullopt, std::nullopt);
    EXPECT_FALSE(criteria.needs_refinement(square.active, e));
    square.mesh.set_deformed(VertexId{2}, true);
    EXPECT_TRUE(criteria.needs_refinement(square.active, e));
}

TEST(MidpointDistance, RemovesAVertexWithinAQuarterOfTheToleranceOfTheMiddle) {
    Square square;
    const Split split = square.active.split(edge_between(square.mesh, 1, 2));
    const double h = 0.01;
    for (const Vec3& off : {Vec3{0.0, 0.0, h}, h * std::sqrt(0.5) * Vec3{1.0, -1.0, 0.0}}) {
        square.mesh.set_position(split.m, Vec3{0.5, 0.5, 0.0} + off);
        const auto is_removable = [&](double tolerance) {
            const Criteria criteria(limits_of(tolerance), std::nullopt, std::nullopt);
            return removable_star(square.active, criteria, split.m).has_value();
        };
        EXPECT_TRUE(is_removable(4.0001 * h));
        EXPECT_FALSE(is_removable(3.9999 * h));
    }
}

TEST(MidpointDistance, KeepsAVertexWhoseEdgeWouldNeedRefinement) {
    Square square;
    const Split split = square.active.split(edge_between(square.mesh, 1, 2));
    // m is in the middle of bc now, but the gesture would take the middle elsewhere.
    square.move(1, {1.0, 0.0, 0.3});
    square.mesh.set_position(split.m, {0.5, 0.5, 0.15});
    const double error = 0.3 / std::sqrt(1.09);
    const auto is_removable = [&](double tolerance) {
        const Criteria criteria(limits_of(tolerance), std::nullopt, std::nullopt);
        return removable_star(square.active, criteria, split.m).has_value();
    };
    EXPECT_TRUE(is_removable(1.0001 * error));
    EXPECT_FALSE(is_removable(0.9999 * error));
}

//      c---d       m splits bc. A gesture has moved a in the plane of the page, but not the middle
//      of
//     / \ /        ab, so delta leads from that edge along the page, and half a unit away from the
//    a---b         edge. The faces at ab, bma and abx, are in the page as well. c is not, so the
//     \ /          restored face bca leaves the page.
//      x
TEST(MidpointDistance, KeepsAVertexWhoseRemovalWouldRaiseTheErrorOfAnOuterEdge) {
    const VertexId a{0}, b{1}, c{2};
    TriMesh mesh = mesh_of(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 -1 0\n"
        "f 1 2 3\nf 3 2 4\nf 2 1 5\n");
    ActiveSet active(mesh);
    active.begin(std::vector<FaceId>{FaceId{0}, FaceId{1}, FaceId{2}}, kEverywhere);
    const Split split = active.split(edge_between(mesh, 1, 2));
    const double height = 0.02;
    mesh.set_position(a, {1.0, -5.0, 0.0});
    mesh.set_deformed(a, true);
    mesh.set_position(c, {0.9, 0.5, height});
    mesh.set_position(split.m, {0.95, 0.25, 0.0});
    const auto criteria = [](double tolerance) {
        return Criteria(limits_of(tolerance), std::nullopt, std::nullopt);
    };
    ASSERT_FALSE(criteria(1e-9).needs_refinement(active, edge_between(mesh, 0, 1)));
    const double error = 0.5 * height / std::hypot(0.1, height);  // of ab, beside bca
    ASSERT_GT(error, 4.0 * glm::distance(mesh.position(split.m),
                                         0.5 * (mesh.position(b) + mesh.position(c))));
    EXPECT_FALSE(removable_star(active, criteria(0.9999 * error), split.m));
    EXPECT_TRUE(removable_star(active, criteria(1.0001 * error), split.m));
    active.cancel();
}

// --- Settings

Session session_with_bump(const command::Adapt& adapt) {
    Session session;
    test::expect_done(session, command::Shape{command::Shape::Kind::plane, 4});
    test::expect_done(session, adapt);
    test::expect_done(session, command::Brush{.radius = 0.8});
    test::expect_done(session, command::Drag{.moves = {{{0.1, 0, 0.2}, {0.1, 0.3, 0.2}}}});
    return session;
}

TEST(MidpointTrigger, HasByDefaultAThousandthOfTheDiagonalAsTolerance) {
    using Trigger = command::Adapt::Trigger;
    const Session automatic = session_with_bump({.trigger = Trigger::midpoint});
    const Session explicit_ = session_with_bump(
        {.trigger = Trigger::midpoint, .tolerance = Setting::of(1e-3 * std::sqrt(8.0))});
    EXPECT_TRUE(automatic.mesh() == explicit_.mesh());
    EXPECT_GT(automatic.mesh().face_count(), 100u);
    EXPECT_FALSE(session_with_bump({}).mesh() == automatic.mesh());
}

TEST(MidpointTrigger, DecimatesToTheBaseMeshOnceTheToleranceAllowsIt) {
    Session session = session_with_bump({.trigger = command::Adapt::Trigger::midpoint});
    ASSERT_GT(session.mesh().face_count(), 100u);
    test::expect_done(session, command::Adapt{.tolerance = Setting::of(10.0),
                                              .l_max = Setting::off(),
                                              .flatness = Setting::off()});
    test::expect_done(session, command::Readapt{});
    EXPECT_EQ(session.mesh().face_count(), 32u);
    EXPECT_EQ(session.mesh().vertex_count(), session.mesh().base_vertex_count());
}

}  // namespace
}  // namespace pectin

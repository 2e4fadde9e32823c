// The edges that other settings would refine, against what readapt does with these settings.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "session/session.h"

namespace pectin {
namespace {

constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();

command::Adapt with_theta_max(double degrees) { return {.theta_max = Setting::of(degrees)}; }

Session dragged_sphere() {
    Session session;
    EXPECT_TRUE(session.execute(command::Shape{command::Shape::Kind::sphere, 3}));
    EXPECT_TRUE(session.execute(command::Adapt{.l_max = Setting::off()}));
    EXPECT_TRUE(session.execute(command::Brush{.radius = 0.6}));
    EXPECT_TRUE(
        session.execute(command::Drag{.moves = {{.from = {0, 0, 1}, .to = {0, 0.2, 1.6}}}}));
    return session;
}

double degrees_across(const TriMesh& mesh, EdgeId e) {
    const HalfEdgeId h = mesh.half_edge(e);
    const Vec3 a(mesh.normal(mesh.wedge(h))), b(mesh.normal(mesh.wedge(TriMesh::next(h))));
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

TEST(EdgesToRefine, AreThoseOfDraggedVerticesThatBendMore) {
    const Session session = dragged_sphere();
    const TriMesh& mesh = session.mesh();
    for (const double theta : {30.0, 15.0, 8.0, 5.0}) {
        SCOPED_TRACE(theta);
        const auto found = session.edges_to_refine(with_theta_max(theta), 0, kAll);
        std::set<EdgeId> set(found.begin(), found.end());
        EXPECT_EQ(set.size(), found.size());
        for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
            const EdgeId e{i};
            if (!mesh.is_live(e)) continue;
            const HalfEdgeId h = mesh.half_edge(e);
            const bool is_deformed =
                mesh.is_deformed(mesh.origin(h)) || mesh.is_deformed(mesh.target(h));
            const double angle = degrees_across(mesh, e);
            if (std::abs(angle - theta) < 1e-3) continue;  // rounding of the normals
            EXPECT_EQ(set.contains(e), is_deformed && angle > theta) << angle;
        }
    }
    EXPECT_GT(session.edges_to_refine(with_theta_max(5.0), 0, kAll).size(),
              session.edges_to_refine(with_theta_max(15.0), 0, kAll).size());
}

TEST(EdgesToRefine, AreNoneExactlyIfReadaptWouldSplitNothing) {
    for (const double theta : {90.0, 40.0, 25.7, 10.0, 4.0}) {
        SCOPED_TRACE(theta);
        Session session = dragged_sphere();
        const bool expects_none = session.edges_to_refine(with_theta_max(theta), 0, kAll).empty();
        EXPECT_TRUE(session.execute(with_theta_max(theta)));
        EXPECT_TRUE(session.execute(command::Readapt{}));
        EXPECT_EQ(session.statistics().last.splits == 0, expects_none);
        EXPECT_TRUE(session.edges_to_refine(with_theta_max(theta), 0, kAll).empty())
            << "after it is done";
    }
}

TEST(EdgesToRefine, OfPartsAddUpToThoseOfTheWhole) {
    const Session session = dragged_sphere();
    const auto whole = session.edges_to_refine(with_theta_max(6.0), 0, kAll);
    std::vector<EdgeId> parts;
    for (std::uint32_t first = 0; first < session.mesh().edge_slots() + 50; first += 97) {
        for (const EdgeId e : session.edges_to_refine(with_theta_max(6.0), first, 97)) {
            parts.push_back(e);
        }
    }
    EXPECT_EQ(parts, whole);
    EXPECT_GT(whole.size(), 10u);
}

TEST(EdgesToRefine, AreNoneBelowTheFloorDuringADragAndForSettingsThatAreRefused) {
    Session session = dragged_sphere();
    command::Adapt coarse_floor = with_theta_max(5.0);
    coarse_floor.floor = Setting::of(1.0);
    EXPECT_TRUE(session.edges_to_refine(coarse_floor, 0, kAll).empty());
    const command::Adapt refused{.theta_max = Setting::of(5.0), .theta_min = Setting::of(6.0)};
    EXPECT_TRUE(session.edges_to_refine(refused, 0, kAll).empty());
    EXPECT_TRUE(Session().edges_to_refine(with_theta_max(5.0), 0, kAll).empty());
    const Vec3 point = session.mesh().position(VertexId{0});
    EXPECT_TRUE(session.begin_drag(std::array{point}, {}));
    EXPECT_TRUE(session.edges_to_refine(with_theta_max(5.0), 0, kAll).empty());
    session.cancel_drag();
    EXPECT_FALSE(session.edges_to_refine(with_theta_max(5.0), 0, kAll).empty());
}

}  // namespace
}  // namespace pectin

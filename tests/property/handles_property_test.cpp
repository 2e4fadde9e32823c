// Tests that a grabbed vertex arrives at its target, even if an earlier drag has inserted it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <tuple>
#include <vector>

#include "session/session.h"
#include "support/random_commands.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

double distance_to_nearest_vertex(const TriMesh& mesh, const Vec3& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const VertexId v{i};
        if (mesh.is_live(v)) nearest = std::min(nearest, glm::distance(mesh.position(v), point));
    }
    return nearest;
}

std::vector<Vec3> inserted_positions(const TriMesh& mesh) {
    std::vector<Vec3> positions;
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const VertexId v{i};
        if (mesh.is_live(v) && !mesh.is_base(v)) positions.push_back(mesh.position(v));
    }
    return positions;
}

const Vec3& any_of(const std::vector<Vec3>& positions, Random& random) {
    return positions[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(positions.size()) - 1))];
}

// Drags a point forth and back. The surface around the inserted vertices is then nearly flat, so
// decimation may remove most of them.
void bend_and_straighten(Session& session, Random& random) {
    const Vec3 from = test::random_surface_point(session.mesh(), random);
    const Vec3 to = from + random.uniform(0.2, 0.6) * random.direction();
    std::ignore = session.execute(command::Drag{.moves = {{from, to}}});
    std::ignore = session.execute(command::Drag{.moves = {{to, from}}});
}

TEST(Handles, AreVerticesThatReachTheirTargets) {
    const int cases = test::case_count(20);
    int dragged = 0, images = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 60'000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_TRUE(session.execute(command::Shape{command::Shape::Kind::sphere, 2}));
        ASSERT_TRUE(session.execute(command::Adapt{.theta_max = Setting::of(random.scale(8, 40)),
                                                   .floor = Setting::of(0.02),
                                                   .budget = 8'000}));
        const bool is_symmetric = random.chance(0.4);
        const Vec3 through{0.0};
        if (is_symmetric) {
            ASSERT_TRUE(session.execute(
                command::Symmetry{.plane = command::Symmetry::Plane::x, .through = through}));
        }
        for (int k = 0; k < 10; ++k) {
            ASSERT_TRUE(session.execute(
                command::Brush{.radius = random.scale(0.2, 1.0),
                               .falloff = k % 2 == 0 ? Falloff::sharp : Falloff::plateau}));
            bend_and_straighten(session, random);
            const std::vector<Vec3> inserted = inserted_positions(session.mesh());
            if (inserted.empty()) continue;
            const Vec3 from = any_of(inserted, random);
            const Vec3 to = from + random.scale(0.001, 0.3) * random.direction();
            command::Drag drag{.moves = {{from, to}}, .fold_free = random.chance(0.3)};
            // If refinement has reached the budget, the mirror image may not be a vertex.
            const bool has_image =
                is_symmetric &&
                distance_to_nearest_vertex(session.mesh(), {-from.x, from.y, from.z}) < 1e-12;
            const Vec3 pin = any_of(inserted, random);
            if (pin != from && random.chance(0.3)) drag.pins.push_back(pin);
            if (!session.execute(drag)) continue;
            ++dragged;
            ASSERT_LT(distance_to_nearest_vertex(session.mesh(), to), 1e-6);
            for (const Vec3& p : drag.pins) {
                ASSERT_LT(distance_to_nearest_vertex(session.mesh(), p), 1e-6);
            }
            if (!has_image) continue;
            const Vec3 image{-to.x, to.y, to.z};
            ASSERT_LT(distance_to_nearest_vertex(session.mesh(), image), 1e-6);
            ++images;
        }
    }
    std::printf("seeds 60000 to %d, %d inserted vertices dragged, %d with an image\n",
                60'000 + cases - 1, dragged, images);
    EXPECT_GT(images, 0);
    EXPECT_GT(dragged, images);
}

}  // namespace
}  // namespace pectin

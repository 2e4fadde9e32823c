// Faces reach beyond the zone of a drag, and may come to intersect faces there that do not move.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

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
using command::Shape;

using test::expect_done;

Session sphere(int resolution, double theta_max) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, resolution});
    expect_done(session, Adapt{.theta_max = Setting::of(theta_max)});
    return session;
}

Drag fold_free(const Vec3& from, const Vec3& to) {
    return {.moves = {{from, to}}, .fold_free = true};
}

// The first drag leaves a sharp wrinkle. The zone of the second ends there, and moves one side of
// the wrinkle a little towards the other.
TEST(BeyondTheZone, AWrinkleAtTheBorderDoesNotIntersectItself) {
    Session session = sphere(3, 40.0);
    expect_done(session, Brush{.radius = 0.82});
    expect_done(session, fold_free({-0.5, 0.31, 0.81}, {-1.03, 0.31, 0.31}));
    ASSERT_EQ(test::crossings(session.mesh()), 0u);
    expect_done(session, Brush{.radius = 1.24});
    expect_done(session, fold_free({0.47, 0.66, 0.55}, {-0.06, 0.85, 1.05}));
    EXPECT_EQ(test::crossings(session.mesh()), 0u);
    EXPECT_EQ(session.remark(), "");
}

// All edges and faces are tested here.
TEST(BeyondTheZone, FoldFreeDragsLeaveNoIntersectionsOrReportThem) {
    int drags = 0, wrong = 0;
    for (int seed = 1; seed <= test::case_count(120); ++seed) {
        test::Random random(static_cast<std::uint64_t>(seed));
        Session session = sphere(2 + seed % 2, random.uniform(20.0, 60.0));
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t count = session.mesh().vertex_slots();
            VertexId v{0};
            do {
                v = VertexId{
                    static_cast<std::uint32_t>(random.integer(0, static_cast<int>(count) - 1))};
            } while (!session.mesh().is_live(v));
            const double radius = random.uniform(0.3, 1.3);
            const Vec3 from = session.mesh().position(v);
            expect_done(session, Brush{.radius = radius});
            expect_done(session, fold_free(from, from + random.uniform(0.2, 1.0) * radius *
                                                            random.direction()));
            ++drags;
            const bool intersects = test::crossings(session.mesh()) > 0;
            const bool is_reported =
                session.remark().find("intersects itself") != std::string::npos;
            EXPECT_EQ(intersects, is_reported) << "seed " << seed << ", drag " << i;
            wrong += intersects != is_reported ? 1 : 0;
            if (intersects) break;
        }
    }
    RecordProperty("drags", drags);
    RecordProperty("wrong", wrong);
}

}  // namespace
}  // namespace pectin

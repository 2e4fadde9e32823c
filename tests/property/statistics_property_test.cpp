// After any drag, also one that folds space, no edge is left that needs refinement and may be
// split.
#include <gtest/gtest.h>

#include <cstdio>

#include "io/obj_writer.h"
#include "session/session.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

VertexId random_vertex(const TriMesh& mesh, Random& random) {
    while (true) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
        if (mesh.is_live(v) && exists(mesh.half_edge(v))) return v;
    }
}

TEST(Statistics, ReportNoEdgeInNeedOfRefinementAfterAnyDrag) {
    const int cases = test::case_count(150);
    int folds = 0, held = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 8000 + static_cast<std::uint64_t>(i);
        Random random(seed);
        const auto [mesh, description] = test::random_mesh(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        const double size = mesh.bounding_box().diagonal();
        Session session;
        const ScratchFolder folder;
        folder.write("a.obj", format_obj(mesh));
        ASSERT_TRUE(session.execute(command::Open{.path = folder.path("a.obj")}));
        ASSERT_TRUE(
            session.execute(command::Adapt{.theta_max = Setting::of(random.scale(4.0, 60.0)),
                                           .floor = Setting::of(size * random.scale(8e-3, 6e-2))}));
        for (int k = 0; k < 4; ++k) {
            SCOPED_TRACE("drag " + std::to_string(k));
            const double radius = size * random.scale(0.1, 1.0);
            ASSERT_TRUE(session.execute(command::Brush{.radius = radius}));
            const Vec3 from = session.mesh().position(random_vertex(session.mesh(), random));
            const Vec3 to = from + radius * random.scale(0.02, 1.5) * random.direction();
            ASSERT_TRUE(session.execute(command::Drag{.moves = {{from, to}}}));
            const Statistics after = session.statistics();
            ASSERT_FALSE(after.budget_hit || after.drag_budget_hit);
            EXPECT_EQ(after.needing_refinement, 0u);
            folds += after.folded_vertices > 0 ? 1 : 0;
            held += after.held_back > 0 ? 1 : 0;
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(folds, cases / 10) << "the drags are too short to fold space";
    EXPECT_GT(held, cases / 10);
    std::printf("seeds 8000 to %d: %d drags folded, after %d some edges were held back\n",
                8000 + cases - 1, folds, held);
}

}  // namespace
}  // namespace pectin

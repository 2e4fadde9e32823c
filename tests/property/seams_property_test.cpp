// Random drags of surfaces whose faces share no vertices open no gap along any seam.
#include <gtest/gtest.h>

#include <cstdio>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "session/session.h"
#include "support/mesh_figures.h"
#include "support/paths.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using command::Drag;
using test::Random;

struct Total {
    int drags = 0;
    std::uint64_t inserted = 0;
};

Command random_drag(const TriMesh& mesh, double size, Random& random) {
    while (true) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
        if (!mesh.is_live(v) || !exists(mesh.half_edge(v))) continue;
        const Vec3 from = mesh.position(v);
        const Vec3 to = from + size * random.scale(0.005, 0.1) * random.direction();
        return Drag{.moves = {{from, to}},
                    .connected = random.chance(0.3),
                    .fold_free = random.chance(0.1)};
    }
}

// The two sides of a seam must have bitwise equal positions. So a side of a polygon without another
// side between the same two positions must be an open edge of the mesh.
void expect_no_gap(const Session& session) {
    const IndexedFaceSet set = parse_obj(format_obj(session.mesh()), "saved.obj");
    ASSERT_LE(test::open_sides(set), test::open_edges(session.mesh()));
    ASSERT_EQ(session.mesh().validate(), std::vector<std::string>{});
}

void drag_at_random(const IndexedFaceSet& shared, int drags, Random& random, Total& total) {
    IndexedFaceSet facets = shared;
    test::unshare_vertices(facets, random);
    const ScratchFolder folder;
    folder.write("a.obj", format_obj(build_mesh(facets).mesh));
    Session session;
    ASSERT_TRUE(session.execute(command::Open{.path = folder.path("a.obj")}));
    const std::string opened = format_obj(session.mesh());
    ASSERT_EQ(session.input_report().boundary_edges, build_mesh(shared).report.boundary_edges);
    const double size = session.mesh().bounding_box().diagonal();
    ASSERT_TRUE(session.execute(command::Adapt{.theta_max = Setting::of(random.scale(8.0, 30.0)),
                                               .floor = Setting::of(0.002 * size),
                                               .budget = 200'000}));
    for (int i = 0; i < drags; ++i) {
        SCOPED_TRACE("drag " + std::to_string(i));
        ASSERT_TRUE(session.execute(command::Brush{.radius = size * random.scale(0.03, 0.3)}));
        if (!session.execute(random_drag(session.mesh(), size, random))) continue;
        ++total.drags;
        expect_no_gap(session);
        if (testing::Test::HasFailure()) return;
        if (random.chance(0.1)) {
            ASSERT_TRUE(session.execute(command::Undo{}));
        }
    }
    total.inserted += session.mesh().vertex_count() - session.mesh().base_vertex_count();
    while (session.execute(command::Undo{})) {
    }
    ASSERT_EQ(format_obj(session.mesh()), opened);
}

TEST(UnsharedSeams, OfGeneratedFacetsNeverOpen) {
    Total total;
    const int cases = test::case_count(12);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 70'000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const ShapeKind kinds[] = {ShapeKind::sphere, ShapeKind::cube, ShapeKind::torus,
                                   ShapeKind::cylinder, ShapeKind::plane};
        const ShapeKind kind = kinds[i % 5];
        drag_at_random(make_shape(kind, kind == ShapeKind::sphere ? 3 : random.integer(3, 8)), 10,
                       random, total);
        if (HasFailure()) return;
    }
    std::printf("seeds 70000 to %d: %d drags, %llu vertices inserted at the ends\n",
                70'000 + cases - 1, total.drags, static_cast<unsigned long long>(total.inserted));
    EXPECT_GT(total.inserted, 0u);
}

TEST(UnsharedSeams, OfRealModelsNeverOpen) {
    const auto models = test::real_models();
    if (models.empty()) GTEST_SKIP() << "no models in " << test::models_folder();
    Total total;
    // A long run makes 500 drags.
    const int wanted = test::is_long() ? 500 : 12;
    const auto count = static_cast<int>(models.size());
    const int each = (wanted + count - 1) / count;
    for (int i = 0; i < count; ++i) {
        const auto& path = models[static_cast<std::size_t>(i)];
        const auto seed = 71'000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE(path + ", seed " + std::to_string(seed));
        Random random(seed);
        for (int done = 0; done < each; done += 10) {
            drag_at_random(read_obj(path), std::min(10, each - done), random, total);
            if (HasFailure()) return;
        }
    }
    std::printf("%d drags on %d models, %llu vertices inserted at the ends\n", total.drags, count,
                static_cast<unsigned long long>(total.inserted));
}

}  // namespace
}  // namespace pectin

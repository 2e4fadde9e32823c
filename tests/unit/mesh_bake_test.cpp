// Baking makes a refined mesh the base mesh.
#include <gtest/gtest.h>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/tri_mesh.h"
#include "mesh/unshared_vertices.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

const std::vector<std::string> kValid;

void split_at_random(TriMesh& mesh, int splits, Random& random) {
    for (int i = 0; i < splits; ++i) {
        const auto edges = test::live_edges(mesh);
        mesh.split(
            edges[static_cast<std::size_t>(random.integer(0, static_cast<int>(edges.size()) - 1))]);
    }
    // Unsplits leave free slots.
    for (std::uint32_t v = mesh.base_vertex_count(); v < mesh.vertex_slots(); ++v) {
        const auto star = mesh.removable(VertexId{v});
        if (star && random.chance(0.3)) mesh.unsplit(*star);
    }
}

template <typename Check>
void for_each_refined_mesh(std::uint64_t first_seed, Check check) {
    const int cases = test::case_count(60);
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
        Random random(seed);
        auto [mesh, description] = test::random_mesh(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        split_at_random(mesh, random.integer(0, 60), random);
        check(mesh);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(Bake, SavesToTheSameBytes) {
    for_each_refined_mesh(600, [](const TriMesh& mesh) {
        const TriMesh baked = mesh.baked();
        EXPECT_EQ(baked.validate(), kValid);
        EXPECT_EQ(format_obj(baked), format_obj(mesh));
    });
}

TEST(Bake, MakesEverythingBaseWithoutHoles) {
    for_each_refined_mesh(700, [](const TriMesh& mesh) {
        const TriMesh baked = mesh.baked();
        // A vertex on an unshared seam becomes as many vertices as a save writes.
        const std::size_t vertices = mesh.vertex_count() + UnsharedVertices(mesh).added().size();
        EXPECT_EQ(baked.base_vertex_count(), vertices);
        EXPECT_EQ(baked.vertex_slots(), vertices);
        EXPECT_EQ(baked.base_face_count(), mesh.face_count());
        EXPECT_EQ(baked.edge_slots(), mesh.edge_count());
        EXPECT_EQ(test::euler_characteristic(baked), test::euler_characteristic(mesh));
        for (std::uint32_t v = 0; v < baked.vertex_slots(); ++v) {
            EXPECT_EQ(baked.level(VertexId{v}), 0);
            EXPECT_FALSE(baked.removable(VertexId{v}).has_value());
        }
    });
}

TEST(Bake, KeepsTheEdgesInTheirOrder) {
    for_each_refined_mesh(800, [](const TriMesh& mesh) {
        const TriMesh baked = mesh.baked();
        std::uint32_t count = 0;
        for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
            if (!mesh.is_live(EdgeId{e})) continue;
            ASSERT_LT(count, baked.edge_slots());
            const HalfEdgeId h = mesh.half_edge(EdgeId{e});
            const HalfEdgeId b = baked.half_edge(EdgeId{count++});
            EXPECT_EQ(baked.position(baked.origin(b)), mesh.position(mesh.origin(h)));
            EXPECT_EQ(baked.position(baked.target(b)), mesh.position(mesh.target(h)));
            EXPECT_EQ(exists(baked.twin(b)), exists(mesh.twin(h)));
        }
    });
}

TEST(Bake, KeepsDeformedMarks) {
    TriMesh mesh = test::mesh_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n");
    mesh.set_deformed(VertexId{1}, true);
    const Split s = mesh.split(test::edge_between(mesh, 1, 2));
    ASSERT_TRUE(mesh.is_deformed(s.m));
    const TriMesh baked = mesh.baked();
    EXPECT_FALSE(baked.is_deformed(VertexId{0}));
    EXPECT_TRUE(baked.is_deformed(VertexId{1}));
    EXPECT_TRUE(baked.is_deformed(VertexId{4}));
}

TEST(Bake, OfAMeshWithoutSplitsChangesNothing) {
    for (std::uint64_t seed = 900; seed < 920; ++seed) {
        Random random(seed);
        const TriMesh mesh = test::random_mesh(random).mesh;
        EXPECT_TRUE(mesh.baked() == mesh) << "seed " << seed;
    }
}

}  // namespace
}  // namespace pectin

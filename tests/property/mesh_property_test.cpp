// Splits and unsplits of random meshes in random order.
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/mesh_change.h"
#include "mesh/tri_mesh.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

const std::vector<std::string> kValid;
// Smaller meshes are validated after every edit.
constexpr std::uint32_t kSmall = 150;

EdgeId random_edge(const TriMesh& mesh, Random& random) {
    while (true) {
        const EdgeId e{
            static_cast<std::uint32_t>(random.integer(0, static_cast<int>(mesh.edge_slots()) - 1))};
        if (mesh.is_live(e)) return e;
    }
}

std::vector<VertexId> removable_vertices(const TriMesh& mesh) {
    std::vector<VertexId> vertices;
    for (std::uint32_t v = mesh.base_vertex_count(); v < mesh.vertex_slots(); ++v) {
        if (mesh.removable(VertexId{v})) vertices.push_back(VertexId{v});
    }
    return vertices;
}

void expect_valid_while_small(const TriMesh& mesh) {
    if (mesh.face_count() <= kSmall) {
        ASSERT_EQ(mesh.validate(), kValid);
    }
}

// No inserted vertex has a neighbour of its own level. Decimation relies on this.
void expect_levels_differ_from_neighbours(const TriMesh& mesh) {
    for (EdgeId e : test::live_edges(mesh)) {
        const HalfEdgeId h = mesh.half_edge(e);
        const int v = mesh.level(mesh.origin(h)), w = mesh.level(mesh.target(h));
        EXPECT_TRUE(v != w || v == 0);
    }
}

template <typename Check>
void for_each_case(std::uint64_t first_seed, int count, Check check) {
    const int cases = test::case_count(count);
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
        Random random(seed);
        auto [mesh, description] = test::random_mesh(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        check(mesh, random);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(Unsplit, InReverseOrderGivesBackTheSameBytes) {
    for_each_case(7000, 200, [](TriMesh& mesh, Random& random) {
        const TriMesh base = mesh;
        const int characteristic = test::euler_characteristic(mesh);
        const double area = test::area(mesh);
        std::vector<std::pair<EdgeId, VertexId>> made;
        const int splits = random.integer(1, 400);
        // Some cases split mostly where they split last, which gives high levels.
        const bool deep = random.chance(0.3);
        EdgeId last = random_edge(mesh, random);
        for (int i = 0; i < splits; ++i) {
            const EdgeId e = deep && random.chance(0.8) ? last : random_edge(mesh, random);
            const Split s = mesh.split(e);
            made.emplace_back(s.bm, s.m);
            last = random.chance(0.5) ? s.am : s.mc;
            expect_valid_while_small(mesh);
        }
        ASSERT_EQ(mesh.validate(), kValid);
        EXPECT_EQ(test::euler_characteristic(mesh), characteristic);
        EXPECT_NEAR(test::area(mesh), area, 1e-9 * area);
        expect_levels_differ_from_neighbours(mesh);
        const TriMesh::RollbackScope scope(mesh, base.slot_counts());
        for (std::size_t i = made.size(); i-- > 0;) {
            const auto star = mesh.removable(made[i].second);
            ASSERT_TRUE(star.has_value());
            ASSERT_EQ(inserted_vertex(mesh, made[i].first), made[i].second);
            ASSERT_EQ(mesh.unsplit(*star), made[i].first);
            expect_valid_while_small(mesh);
        }
        EXPECT_TRUE(mesh == base);
    });
}

TEST(Unsplit, InAnyLegalOrderEndsInTheBaseMesh) {
    for_each_case(7500, 200, [](TriMesh& mesh, Random& random) {
        const TriMesh base = mesh;
        const int splits = random.integer(1, 200);
        for (int i = 0; i < splits; ++i) mesh.split(random_edge(mesh, random));
        while (true) {
            const auto vertices = removable_vertices(mesh);
            if (vertices.empty()) break;
            // Removes several at a time: removing one must not make another of its level
            // irremovable.
            const auto pick =
                static_cast<std::size_t>(random.integer(0, static_cast<int>(vertices.size()) - 1));
            for (std::size_t i = pick; i < std::min(pick + 5, vertices.size()); ++i) {
                const auto star = mesh.removable(vertices[i]);
                ASSERT_TRUE(star.has_value());
                mesh.unsplit(*star);
            }
            expect_valid_while_small(mesh);
        }
        ASSERT_EQ(mesh.validate(), kValid);
        EXPECT_TRUE(test::has_the_faces_of(mesh, base));
    });
}

TEST(Split, MixedWithUnsplitKeepsTheMeshValidAndItsEulerCharacteristic) {
    for_each_case(8000, 200, [](TriMesh& mesh, Random& random) {
        const TriMesh base = mesh;
        const int characteristic = test::euler_characteristic(mesh);
        const double area = test::area(mesh);
        const int edits = random.integer(1, 250);
        const double growth = random.uniform(0.3, 0.8);
        for (int i = 0; i < edits; ++i) {
            if (random.chance(growth)) {
                const EdgeId e = random_edge(mesh, random);
                const int level = mesh.level(e);
                const HalfEdgeId bc = mesh.half_edge(e);
                int highest = std::max(mesh.level(mesh.origin(bc)), mesh.level(mesh.target(bc)));
                mesh.for_each_side(e, [&](HalfEdgeId h) {
                    highest = std::max(highest, int{mesh.level(mesh.origin(TriMesh::prev(h)))});
                });
                const Split s = mesh.split(e);
                ASSERT_EQ(mesh.level(s.m), highest + 1);
                ASSERT_EQ(mesh.level(s.bm), level);
                ASSERT_EQ(mesh.level(s.mc), level);
            } else if (const auto removable = removable_vertices(mesh); !removable.empty()) {
                const VertexId m = removable[static_cast<std::size_t>(
                    random.integer(0, static_cast<int>(removable.size()) - 1))];
                const auto star = mesh.removable(m);
                ASSERT_EQ(star->mc, TriMesh::half_edge(TriMesh::face(star->mc), 0));
                mesh.unsplit(*star);
            }
            expect_valid_while_small(mesh);
            ASSERT_EQ(test::euler_characteristic(mesh), characteristic);
        }
        ASSERT_EQ(mesh.validate(), kValid);
        EXPECT_NEAR(test::area(mesh), area, 1e-9 * area);
        expect_levels_differ_from_neighbours(mesh);
        for (std::uint32_t v = 0; v < base.vertex_slots(); ++v) {
            ASSERT_EQ(mesh.position(VertexId{v}), base.position(VertexId{v}));
        }
    });
}

}  // namespace
}  // namespace pectin

#include "adapt/propagation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "adapt/refine.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

TEST(Propagation, EndsWhereNoNeighbourIsLonger) {
    int longest = 0, others = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        ActiveSet active(mesh);
        const Box zone = mesh.bounding_box();
        active.begin(FaceTree(mesh).faces_meeting(zone, mesh), zone);
        const AdaptLimits limits{.propagation = random.scale(1.0, 1.4)};
        Propagation propagation(active, limits, [](EdgeId) { return true; });
        for (EdgeId e : test::live_edges(mesh)) {
            std::vector<EdgeId> chain{e};
            EXPECT_FALSE(propagation.extend(chain));  // no edge is blocked
            const auto longest_neighbour = [&](EdgeId of) {
                float length = 0.0f;
                mesh.for_each_side(of, [&](HalfEdgeId h) {
                    length = std::max({length, active.rest_length(mesh.edge(TriMesh::next(h))),
                                       active.rest_length(mesh.edge(TriMesh::prev(h)))});
                });
                return static_cast<double>(length);
            };
            const auto most = [&](EdgeId of) {
                return limits.propagation * static_cast<double>(active.rest_length(of));
            };
            EXPECT_LE(longest_neighbour(chain.back()), most(chain.back()));
            const bool is_longest = longest_neighbour(e) <= most(e);
            EXPECT_EQ(chain.size() == 1, is_longest);
            ++(is_longest ? longest : others);
        }
        active.abandon();
    }
    EXPECT_GT(longest, 100);
    EXPECT_GT(others, 100);
}

// A fan around one vertex. Each spoke is a little longer than the one before, so that propagation
// leads from the first spoke to the last.
IndexedFaceSet fan(std::uint32_t spokes) {
    IndexedFaceSet input;
    input.parts.emplace_back();
    input.positions.emplace_back(0.0);
    for (std::uint32_t i = 0; i <= spokes; ++i) {
        const double angle = 3.0 * i / spokes, length = 1.0 + 1.0 * i / spokes;
        input.positions.push_back(length * Vec3{std::cos(angle), std::sin(angle), 0.0});
    }
    for (std::uint32_t i = 0; i < spokes; ++i) {
        input.corners.insert(input.corners.end(), {{0}, {i + 1}, {i + 2}});
        input.polygon_end.push_back(3 * (i + 1));
        input.polygon_part.push_back(0);
    }
    return input;
}

TEST(Propagation, ComparesEachEdgeOfALongChainAFewTimesOnly) {
    std::uint64_t longest = 0;
    for (const std::uint32_t spokes : {100u, 1000u, 10'000u}) {
        TriMesh mesh = build_mesh(fan(spokes)).mesh;
        ActiveSet active(mesh);
        const Box zone{.min = {0.9, -0.1, -0.1}, .max = {1.1, 1e-6, 0.1}};
        active.begin(FaceTree(mesh).faces_meeting(mesh.bounding_box(), mesh), mesh.bounding_box());
        const Warp warp;
        Embedding embedding(active, warp);
        embedding.embed();
        const Refinement result =
            refine(active, embedding, Criteria({.l_max = 0.9, .floor = 1e-9}, zone, zone));
        EXPECT_GE(result.splits, spokes);
        EXPECT_LE(result.chain_steps, 4 * result.splits) << spokes << " spokes";
        longest = std::max(longest, result.chain_steps);
        active.finish();
        EXPECT_EQ(mesh.validate(), std::vector<std::string>{});
    }
    EXPECT_GT(longest, 10'000u);
}

// The level of a vertex is limited. At the limit, no edge of the fan may be split any more.
TEST(Propagation, ComparesEachEdgeOfAChainThatMayNotBeSplitAFewTimesOnly) {
    constexpr std::uint32_t kSpokes = 80'000;
    TriMesh mesh = build_mesh(fan(kSpokes)).mesh;
    ActiveSet active(mesh);
    const Box zone = mesh.bounding_box();
    active.begin(FaceTree(mesh).faces_meeting(zone, mesh), zone);
    const Warp warp;
    Embedding embedding(active, warp);
    embedding.embed();
    const Refinement result =
        refine(active, embedding, Criteria({.l_max = 0.9, .floor = 1e-9}, zone, zone));
    EXPECT_TRUE(result.floor_hit);
    EXPECT_LE(result.chain_steps, 10 * (result.splits + kSpokes));
    active.finish();
}

}  // namespace
}  // namespace pectin

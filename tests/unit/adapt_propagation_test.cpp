#include "adapt/propagation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

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
            const auto chain = propagation.chain(e);
            EXPECT_FALSE(chain.leaves_sliver);  // nothing is held back
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
            EXPECT_LE(longest_neighbour(chain.end), most(chain.end));
            const bool is_longest = longest_neighbour(e) <= most(e);
            EXPECT_EQ(chain.end == e, is_longest);
            ++(is_longest ? longest : others);
        }
        active.abandon();
    }
    EXPECT_GT(longest, 100);
    EXPECT_GT(others, 100);
}

}  // namespace
}  // namespace pectin

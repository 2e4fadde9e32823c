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
            std::vector<double> neighbours;
            mesh.for_each_side(chain.end, [&](HalfEdgeId h) {
                neighbours.push_back(mesh.length(mesh.edge(TriMesh::next(h))));
                neighbours.push_back(mesh.length(mesh.edge(TriMesh::prev(h))));
            });
            EXPECT_LE(*std::ranges::max_element(neighbours),
                      (1.0 + 1e-6) * limits.propagation * mesh.length(chain.end));
            if (propagation.is_longest(e)) {
                EXPECT_EQ(chain.end, e);
                ++longest;
            } else if (mesh.sibling(e) == e) {
                EXPECT_NE(chain.end, e);
                ++others;
            }
        }
        active.abandon();
    }
    EXPECT_GT(longest, 100);
    EXPECT_GT(others, 100);
}

}  // namespace
}  // namespace pectin

// The first face that a ray meets: the tree gives the same result as a scan.
#include <gtest/gtest.h>

#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

std::optional<FaceHit> first_hit_by_scan(const Ray& ray, const TriMesh& mesh) {
    std::optional<FaceHit> first;
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
        if (!mesh.is_live(FaceId{i})) continue;
        const auto corner = [&](int k) {
            return mesh.position(mesh.origin(TriMesh::half_edge(FaceId{i}, k)));
        };
        const auto hit = intersect(ray, corner(0), corner(1), corner(2));
        if (hit && (!first || hit->t < first->hit.t)) first = FaceHit{FaceId{i}, *hit};
    }
    return first;
}

TEST(FaceTreePick, MatchesBruteForce) {
    for (int i = 0; i < test::case_count(60); ++i) {
        const std::uint64_t seed = 7000 + static_cast<std::uint64_t>(i);
        test::Random random(seed);
        const auto [mesh, description] = test::random_mesh(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        const FaceTree tree(mesh);
        const Box box = mesh.bounding_box();
        const double size = box.diagonal();
        int hits = 0;
        for (int k = 0; k < 50; ++k) {
            const Vec3 from = box.centre() + size * random.scale(0.01, 3.0) * random.direction();
            const Vec3 at = box.centre() + 0.4 * size * random.direction();
            const Ray ray{from, at - from};
            const auto found = tree.first_hit(ray, mesh);
            const auto expected = first_hit_by_scan(ray, mesh);
            ASSERT_EQ(found.has_value(), expected.has_value());
            if (!found) continue;
            ++hits;
            EXPECT_EQ(found->hit.t, expected->hit.t);
            EXPECT_EQ(found->face, expected->face);
        }
        EXPECT_TRUE(hits > 0 || description.starts_with("shape 2")) << "no ray met a closed mesh";
    }
}

// Rays from inside a closed sphere through its vertices never pass between faces.
TEST(FaceTreePick, HitsAClosedMeshWithEveryRay) {
    test::Random random(1);
    const auto mesh = build_mesh(make_shape(ShapeKind::sphere, 3)).mesh;
    const FaceTree tree(mesh);
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        const Vec3 inside = 0.3 * random.direction();
        EXPECT_TRUE(tree.first_hit({inside, mesh.position(VertexId{v}) - inside}, mesh)) << v;
    }
    for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
        const HalfEdgeId h = mesh.half_edge(EdgeId{e});
        const Vec3 at = 0.5 * mesh.position(mesh.origin(h)) + 0.5 * mesh.position(mesh.target(h));
        EXPECT_TRUE(tree.first_hit({Vec3{0.0}, at}, mesh)) << e;
    }
}

}  // namespace
}  // namespace pectin

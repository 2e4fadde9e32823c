// The blocked pass over a frame that moved control points, against the field element by element.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "embedding/embedding.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"

namespace pectin {
namespace {

std::vector<FaceId> all_faces(const TriMesh& mesh) {
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) faces.push_back(FaceId{f});
    return faces;
}

LatticeField bent_field() {
    const Lattice lattice{
        .origin = Vec3{-0.6, -0.5, -0.4}, .cell = Vec3{0.5, 0.6, 0.7}, .deformable = {2, 3, 2}};
    std::vector<Vec3> displacements(lattice.control_count());
    for (std::size_t c = 0; c < displacements.size(); ++c) {
        const auto at = static_cast<double>(c);
        displacements[c] = {0.2 * std::sin(at), 0.1 * std::cos(2.0 * at),
                            0.15 * std::sin(3.0 * at)};
    }
    return {lattice, displacements};
}

void expect_deformed(const TriMesh& before, const TriMesh& after, const LatticeField& field) {
    std::size_t moved = 0;
    for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
        const Vec3 x = before.position(VertexId{v}), d = field.displacement(x);
        const Vec3& to = after.position(VertexId{v});
        ASSERT_LT(glm::distance(to, x + d), 1e-15);
        ASSERT_EQ(after.is_deformed(VertexId{v}), to != x);
        ASSERT_TRUE(field.lattice().influences(x) || to == x);
        moved += to != x ? 1 : 0;
    }
    EXPECT_GT(moved, 1000u);
    EXPECT_LT(moved, before.vertex_slots() - 100u);
    for (const FaceId f : all_faces(before)) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(f, corner);
            const WedgeId w = before.wedge(h);
            const Mat3 jacobian = field.jacobian(before.position(before.origin(h)));
            ASSERT_LT(glm::distance(after.normal(w), covariant(jacobian, before.normal(w))), 1e-6f);
        }
    }
}

// A sphere has one normal for each vertex, so that one pass sets positions and normals; at the
// creases of a cube there are several.
TEST(LatticePass, MatchesThePerVertexField) {
    const LatticeField field = bent_field();
    for (const auto& [kind, resolution] :
         {std::pair{ShapeKind::sphere, 5}, std::pair{ShapeKind::cube, 40}}) {
        const TriMesh shape = build_mesh(make_shape(kind, resolution)).mesh;
        TriMesh mesh = shape;
        ActiveSet active(mesh);
        active.begin(all_faces(mesh), field.lattice().influenced_zone());
        Warp warp{{field}};
        Embedding embedding(active, warp);
        embedding.embed();
        embedding.deform();
        expect_deformed(shape, mesh, field);
        // The next frame has other displacements.
        std::get<LatticeField>(warp.steps[0]).displacements()[0] += Vec3{0.1};
        embedding.deform();
        expect_deformed(shape, mesh, std::get<LatticeField>(warp.steps[0]));
        active.roll_back();
        active.finish();
        EXPECT_TRUE(mesh == shape);
    }
}

}  // namespace
}  // namespace pectin

// No diagonal has the ends of another edge where another diagonal is possible.
#include "mesh/shared_diagonals.h"

#include <gtest/gtest.h>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "support/mesh_figures.h"

namespace pectin {
namespace {

// Two quads that share three corners.
const std::string kDoublet =
    "v -2.4941 1.0642 4.9008\nv -2.4941 1.0564 4.8539\nv -2.4941 1.1111 4.8461\n"
    "v -2.455 1.1267 4.8851\nv -2.5331 1.1267 4.8851\n"
    "f 1 4 3 2\nf 1 2 3 5\n";

BuiltMesh build(const std::string& obj) { return build_mesh(parse_obj(obj, "t.obj")); }

void expect_manifold(const BuiltMesh& built) {
    EXPECT_EQ(built.mesh.validate(), std::vector<std::string>{});
    EXPECT_EQ(built.report.nonmanifold_edges, 0u);
    EXPECT_EQ(built.report.misoriented_edges, 0u);
}

TEST(SharedDiagonals, TwoQuadsThatShareThreeCornersGetDifferentOnes) {
    const BuiltMesh built = build(kDoublet);
    expect_manifold(built);
    EXPECT_EQ(built.report.boundary_edges, 4u);
    EXPECT_EQ(test::euler_characteristic(built.mesh), 1);
}

TEST(SharedDiagonals, PolygonsAreSavedAsTheyCameAndSplitOnesOpenAsManifolds) {
    BuiltMesh built = build(kDoublet);
    const std::string text = format_obj(built.mesh);
    EXPECT_NE(text.find("\nf 1//1 4//2 3//3 2//4\n"), text.npos) << text;
    EXPECT_NE(text.find("\nf 1//5 2//6 3//7 5//8\n"), text.npos) << text;
    built.mesh.split(test::edge_between(built.mesh, 0, 1));
    const BuiltMesh again = build(format_obj(built.mesh));
    expect_manifold(again);
    EXPECT_EQ(again.mesh.face_count(), built.mesh.face_count());
}

TEST(SharedDiagonals, AQuadGetsTheOtherOneWhereAnEdgeRunsAlongTheFirst) {
    // The shorter diagonal 1-3 is a side of the triangle.
    const BuiltMesh built =
        build("v 0 0 0\nv 3 -1 0\nv 6 0 0\nv 3 1 0\nv 3 0 2\nf 1 2 3 4\nf 2 4 5\n");
    expect_manifold(built);
    EXPECT_EQ(test::edge_between(built.mesh, 0, 2), test::edge_between(built.mesh, 2, 0));
}

TEST(SharedDiagonals, LargerPolygonsChangeTheirTriangulationToo) {
    // A hexagon whose triangles would use the side of the triangle that stands on it.
    const std::string hexagon =
        "v 2 0 0\nv 1 1.2 0\nv -1 1.2 0\nv -2 0 0\nv -1 -1.2 0\nv 1 -1.2 0\nv 0 0 3\n"
        "f 1 2 3 4 5 6\n";
    const TriMesh alone = build(hexagon).mesh;
    int tried = 0;
    for (const EdgeId e : test::live_edges(alone)) {
        const HalfEdgeId h = alone.half_edge(e);
        if (!exists(alone.twin(h))) continue;
        const std::string v = std::to_string(index(alone.origin(h)) + 1);
        const std::string w = std::to_string(index(alone.target(h)) + 1);
        expect_manifold(build(hexagon + "f " + v + ' ' + w + " 7\n"));
        ++tried;
    }
    EXPECT_EQ(tried, 3);
}

TEST(SharedDiagonals, AreKeptWhereTheOtherOneWouldFoldTheQuad) {
    // The arrowhead is only covered along 2-4, which the triangle's side shares.
    const BuiltMesh built =
        build("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nv 1 1 2\nf 1 2 3 4\nf 2 4 5\n");
    EXPECT_EQ(built.mesh.validate(), std::vector<std::string>{});
    EXPECT_EQ(built.report.nonmanifold_edges, 1u);
}

TEST(SharedDiagonals, BothQuadsExchangeWhereTheyMirrorEachOther) {
    // Each other's image at y = 0; the shorter diagonal of both lies there.
    const BuiltMesh built =
        build("v -1 0 0\nv 0 -1 1\nv 1 0 0\nv 0 4 2\nv 0 1 1\nv 0 -4 2\nf 1 2 3 4\nf 3 5 1 6\n");
    expect_manifold(built);
    EXPECT_EQ(test::faces_without_image(built.mesh, 1, 1e-12), 0u);
}

}  // namespace
}  // namespace pectin

// Tests that no diagonal of a polygon joins the ends of another edge if a different diagonal is
// possible.
#include "mesh/shared_diagonals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::Random;

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

TEST(SharedDiagonals, QuadsThatShareThreeCornersGetDifferentDiagonals) {
    const BuiltMesh built = build(kDoublet);
    expect_manifold(built);
    EXPECT_EQ(built.report.boundary_edges, 4u);
    EXPECT_EQ(test::euler_characteristic(built.mesh), 1);
}

TEST(SharedDiagonals, UntouchedPolygonsAreSavedAsReadAndSplitOnesOpenAsManifolds) {
    BuiltMesh built = build(kDoublet);
    const std::string text = format_obj(built.mesh);
    EXPECT_NE(text.find("\nf 1//1 4//2 3//3 2//4\n"), text.npos) << text;
    EXPECT_NE(text.find("\nf 1//5 2//6 3//7 5//8\n"), text.npos) << text;
    built.mesh.split(test::edge_between(built.mesh, 0, 1));
    const BuiltMesh again = build(format_obj(built.mesh));
    expect_manifold(again);
    EXPECT_EQ(again.mesh.face_count(), built.mesh.face_count());
}

TEST(SharedDiagonals, AQuadGetsTheOtherDiagonalIfAnEdgeJoinsTheEndsOfTheFirst) {
    // The shorter diagonal of the quad joins its corners 2 and 4, which is a side of the triangle.
    const BuiltMesh built =
        build("v 0 0 0\nv 3 -1 0\nv 6 0 0\nv 3 1 0\nv 3 0 2\nf 1 2 3 4\nf 2 4 5\n");
    expect_manifold(built);
    EXPECT_EQ(test::edge_between(built.mesh, 0, 2), test::edge_between(built.mesh, 2, 0));
}

TEST(SharedDiagonals, LargerPolygonsAlsoGetOtherDiagonals) {
    // A triangle stands on the hexagon, along one of the diagonals that the hexagon would get.
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

TEST(SharedDiagonals, AreKeptIfTheOtherDiagonalWouldFoldTheQuad) {
    // Only the diagonal 2-4 divides the arrowhead without a fold, and it is also a side of the
    // triangle.
    const BuiltMesh built =
        build("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nv 1 1 2\nf 1 2 3 4\nf 2 4 5\n");
    EXPECT_EQ(built.mesh.validate(), std::vector<std::string>{});
    EXPECT_EQ(built.report.nonmanifold_edges, 1u);
}

TEST(SharedDiagonals, BothOfTwoMirroredQuadsGetTheOtherDiagonal) {
    // The quads are mirror images about y = 0, and the shorter diagonal of both lies in that plane.
    const BuiltMesh built =
        build("v -1 0 0\nv 0 -1 1\nv 1 0 0\nv 0 4 2\nv 0 1 1\nv 0 -4 2\nf 1 2 3 4\nf 3 5 1 6\n");
    expect_manifold(built);
    EXPECT_EQ(test::faces_without_image(built.mesh, 1, 1e-12), 0u);
}

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// A polygon in x > 0 and its mirror image about x = 0. On each, a triangle stands on every diagonal
// in `fins`. The polygon begins with the corner `first`, and the image with `first_of_image`.
std::string finned_polygons(const std::vector<Vec2>& corners, const Pairs& fins, std::size_t first,
                            std::size_t first_of_image, bool image_comes_first) {
    const std::size_t n = corners.size(), vertices = n + fins.size();
    std::ostringstream text;
    text.precision(17);
    std::string faces[2] = {"f", "f"};
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        for (const Vec2& p : corners) text << "v " << sign * p.x << ' ' << p.y << " 0\n";
        for (std::size_t i = 0; i < fins.size(); ++i)
            text << "v " << sign * 3 << " 0 " << i + 1 << '\n';
    }
    for (std::size_t i = 0; i < n; ++i) {
        faces[0] += ' ' + std::to_string(1 + (first + i) % n);
        faces[1] += ' ' + std::to_string(1 + vertices + (first_of_image + n - i) % n);
    }
    if (image_comes_first) std::swap(faces[0], faces[1]);
    text << faces[0] << '\n' << faces[1] << '\n';
    for (std::size_t i = 0; i < fins.size(); ++i) {
        const auto [a, b] = fins[i];
        text << "f " << a + 1 << ' ' << b + 1 << ' ' << n + i + 1 << '\n';
        text << "f " << vertices + b + 1 << ' ' << vertices + a + 1 << ' ' << vertices + n + i + 1
             << '\n';
    }
    return text.str();
}

TEST(SharedDiagonals, TwoInOnePolygonAreExchangedOneAfterTheOtherAndSymmetrically) {
    // Pentagons with the diagonals 0-2 and 0-3. In the second pentagon both exchanges would give
    // diagonals of the same length.
    const std::vector<std::vector<Vec2>> shapes{
        {{3, 0.8}, {1.6, 0.5}, {2.4, -0.6}, {3.7, -0.7}, {4.3, 0.4}},
        {{3, 0.75}, {1.5, 0.5}, {2.5, -0.5}, {3.5, -0.5}, {4.5, 0.5}}};
    for (const auto& corners : shapes) {
        for (std::size_t i = 0; i < 50; ++i) {
            const std::string text =
                finned_polygons(corners, {{0, 2}, {0, 3}}, i % 5, i / 5 % 5, i >= 25);
            const BuiltMesh built = build(text);
            expect_manifold(built);
            EXPECT_EQ(test::faces_without_image(built.mesh, 0, 1e-12), 0u) << text;
            if (HasFailure()) return;
        }
    }
}

TEST(SharedDiagonals, OfRandomPolygonsAreExchangedSymmetrically) {
    Random random(61);
    for (int i = 0; i < 300; ++i) {
        const auto n = static_cast<std::size_t>(random.integer(5, 12));
        std::vector<Vec2> corners;
        for (std::size_t k = 0; k < n; ++k) {
            const double a =
                2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
            const double r = random.uniform(0.7, 1.3);
            corners.push_back({3.0 + r * std::cos(a), r * std::sin(a)});
        }
        Pairs fins;
        for (std::size_t a = 0; a < n; ++a) {
            for (std::size_t b = a + 2; b < n; ++b) {
                if ((a > 0 || b + 1 < n) && random.chance(0.4)) fins.push_back({a, b});
            }
        }
        const auto corner = [&] {
            return static_cast<std::size_t>(random.integer(0, static_cast<int>(n) - 1));
        };
        const std::string text =
            finned_polygons(corners, fins, corner(), corner(), random.chance(0.5));
        const BuiltMesh built = build(text);
        ASSERT_EQ(built.mesh.validate(), std::vector<std::string>{});
        ASSERT_EQ(test::faces_without_image(built.mesh, 0, 1e-12), 0u) << text;
    }
}

}  // namespace
}  // namespace pectin

// Drags that are many radii long: refinement follows the surface and not the number of steps, and
// what the steps do between the corners of large faces is noticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "mesh/face_tree.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/paths.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Drag;
using command::Shape;

using test::expect_done;

// The largest distance from a vertex of `exact` to the surface of `approximation`.
double largest_distance(const TriMesh& exact, const TriMesh& approximation) {
    const FaceTree tree(approximation);
    double largest = 0.0;
    for (std::uint32_t i = 0; i < exact.vertex_slots(); ++i) {
        if (!exact.is_live(VertexId{i})) continue;
        const Vec3 p = exact.position(VertexId{i});
        const HalfEdgeId h = TriMesh::half_edge(tree.nearest(p, approximation).value(), 0);
        const auto corner = [&](HalfEdgeId at) {
            return approximation.position(approximation.origin(at));
        };
        const Vec3 nearest =
            nearest_on_triangle(p, corner(h), corner(TriMesh::next(h)), corner(TriMesh::prev(h)));
        largest = std::max(largest, glm::distance(p, nearest));
    }
    return largest;
}

constexpr double kRadius = 0.02;

// A sphere, of which one point is dragged outwards by a number of radii.
Session spike(double radii, const Setting& l_max, bool connected = true) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, 3});
    expect_done(session, Adapt{.l_max = l_max, .floor = Setting::of(1e-4)});
    expect_done(session, Brush{.radius = kRadius});
    const Vec3 from{0, 0, 1}, to{0.3 * radii * kRadius, 0, 1 + radii * kRadius};
    expect_done(session, Drag{.moves = {{from, to}}, .connected = connected, .fold_free = true});
    return session;
}

TEST(LongDrag, IsRefinedByWhatTheSurfaceNeedsAndNotForEachStep) {
    const Session short_spike = spike(10, Setting::automatic());
    const Session long_spike = spike(60, Setting::automatic(), false);
    const Statistics few = short_spike.statistics(), many = long_spike.statistics();
    EXPECT_GE(many.last.steps, 5 * few.last.steps);
    EXPECT_GT(few.last.splits, 200u);
    EXPECT_LT(many.last.splits, 3 * few.last.splits);
    EXPECT_LT(many.last.splits, 2000u);
    EXPECT_EQ(many.needing_refinement, 0u);
    EXPECT_EQ(many.folded_vertices, 0u);
    EXPECT_EQ(test::crossings(long_spike.mesh()), 0u);
}

// The radius suits a much smaller model.
TEST(LongDrag, WithTheRadiusOfAnotherModelSplitsFewEdges) {
    struct Case {
        const char* model;
        double radius;
        Vec3 from, to;
    };
    for (const Case& c : {Case{"rocker-arm.obj",
                               0.002097,
                               {0.01026, 0.257456, 0.086286},
                               {0.0661800202, 0.34133603, 0.14220602}},
                          Case{"spot.obj",
                               0.004659,
                               {0.17745, 0.953646, -0.260405},
                               {0.301678322, 1.13998848, -0.136176678}}}) {
        const std::string path = test::models_folder() + "/" + c.model;
        if (!std::filesystem::exists(path)) GTEST_SKIP() << "no model " << path;
        Session session;
        expect_done(session, command::Open{.path = path});
        expect_done(session, Brush{.radius = c.radius});
        expect_done(session, Drag{.moves = {{c.from, c.to}}, .connected = true, .fold_free = true});
        EXPECT_EQ(session.statistics().last.steps, 143u);
        EXPECT_LT(session.statistics().last.splits, 2000u) << c.model;
    }
}

// A length that the user sets holds for the result, and gives the surface to compare with.
TEST(LongDrag, IsAsExactAsOneWithShortEdgesEverywhere) {
    constexpr double kLMax = kRadius / 3;  // what it is automatically
    const Session exact = spike(12, Setting::of(kLMax));
    const Session usual = spike(12, Setting::automatic());
    EXPECT_GT(exact.statistics().last.splits, 4 * usual.statistics().last.splits);
    EXPECT_LT(largest_distance(exact.mesh(), usual.mesh()), 0.03 * kRadius);
    EXPECT_LT(largest_distance(usual.mesh(), exact.mesh()), 0.03 * kRadius);
    // Edges on the spike, which is far from all edges that the drag does not reach.
    double longest = 0.0;
    for (EdgeId e : test::live_edges(exact.mesh())) {
        const HalfEdgeId h = exact.mesh().half_edge(e);
        const double height = exact.mesh().position(exact.mesh().origin(h)).z;
        if (height > 1 + kRadius) longest = std::max(longest, exact.mesh().squared_length(e));
    }
    EXPECT_LE(longest, kLMax * kLMax);
}

// Every face that is drawn out beyond `height` stays near the axis of the drag, which is parallel
// to the y axis: what lies between its corners is as narrow as the corners tell.
void expect_narrow(const TriMesh& mesh, const Vec3& from, double height, double radius) {
    for (FaceId f : test::live_faces(mesh)) {
        double highest = 0.0, farthest = 0.0;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 p = mesh.position(mesh.origin(TriMesh::half_edge(f, corner)));
            highest = std::max(highest, p.y);
            farthest = std::max(farthest, std::hypot(p.x - from.x, p.z - from.z));
        }
        if (highest > height) {
            ASSERT_LT(farthest, radius) << "a face reaches up to " << highest;
        }
    }
}

// A grid of n by n quads with side 8.
std::string sheet(int n, double y, int first_vertex) {
    std::string text;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            text += "v " + std::to_string(8.0 * i / n - 4.0) + " " + std::to_string(y) + " " +
                    std::to_string(8.0 * j / n - 4.0) + "\n";
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const int a = first_vertex + i * (n + 1) + j, b = a + n + 1;
            text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " +
                    std::to_string(b + 1) + " " + std::to_string(b) + "\n";
        }
    }
    return text;
}

// The point goes through a second sheet of faces that are large beside the brush. The first path
// passes through a vertex there, which the steps move but do not tilt.
TEST(LongDrag, BendsASheetOfLargeFacesThatItReachesOnTheWay) {
    const ScratchFolder folder;
    folder.write("sheets.obj", sheet(4, 0.0, 1) + sheet(4, 1.0, 26));
    for (const Vec3& from : {Vec3{0, 0, 0}, Vec3{0.9, 0, 0.3}, Vec3{-1.3, 0, 1.1}}) {
        Session session;
        expect_done(session, command::Open{.path = folder.path("sheets.obj")});
        expect_done(session, Brush{.radius = 0.2});
        expect_done(session, Drag{.moves = {{from, from + Vec3{0, 2.5, 0}}}, .fold_free = true});
        EXPECT_GT(session.statistics().last.steps, 20u);
        EXPECT_EQ(session.statistics().needing_refinement, 0u);
        EXPECT_EQ(test::crossings(session.mesh()), 0u);
        expect_narrow(session.mesh(), from, 1.3, 0.5);
        // The second sheet is pushed ahead of the first.
        EXPECT_GT(session.mesh().bounding_box().max.y, 2.5 + 1e-6);
    }
}

TEST(LongDrag, BendsTheOppositeSideOfACubeNarrowly) {
    Session session;
    expect_done(session, Shape{Shape::Kind::cube, 2});
    expect_done(session, Brush{.radius = 0.1});
    expect_done(session, Drag{.moves = {{{0, -1, 0}, {0, 2.5, 0}}}, .fold_free = true});
    EXPECT_GT(session.statistics().last.steps, 60u);
    EXPECT_LT(session.statistics().last.splits, 10'000u);
    EXPECT_EQ(test::crossings(session.mesh()), 0u);
    expect_narrow(session.mesh(), Vec3{0.0}, 1.2, 0.3);
}

TEST(LongDrag, KeepsASymmetricMeshSymmetricAndCanBeUndone) {
    for (const double through : {0.0, 0.7}) {
        Session session;
        expect_done(session, Shape{Shape::Kind::sphere, 3});
        expect_done(session, Brush{.radius = 0.05});
        const bool is_symmetric = through == 0.0;  // of the sphere
        expect_done(session, command::Symmetry{.plane = command::Symmetry::Plane::x,
                                               .through = {through, 0, 0}});
        const TriMesh before = session.mesh();
        expect_done(session, Drag{.moves = {{{0, 0, 1}, {is_symmetric ? 0.0 : 0.1, 0.4, 1.8}}},
                                  .fold_free = true});
        EXPECT_GT(session.statistics().last.steps, 15u);
        EXPECT_EQ(session.statistics().needing_refinement, 0u);
        if (is_symmetric) {
            EXPECT_EQ(test::faces_without_image(session.mesh(), 0, 1e-9), 0u);
        }
        const TriMesh after = session.mesh();
        expect_done(session, command::Undo{});
        EXPECT_TRUE(session.mesh() == before);
        expect_done(session, command::Redo{});
        EXPECT_TRUE(session.mesh() == after);
    }
}

// The border bends in the plane of its faces, where all normals are the same.
TEST(LongDrag, FollowsABorderThatBendsInItsPlane) {
    const auto border = [](const Setting& l_max) {
        Session session;
        expect_done(session, Shape{Shape::Kind::plane, 2});
        expect_done(session, Adapt{.l_max = l_max});
        expect_done(session, Brush{.radius = 0.1});
        const Vec3 from{0, 0, 1};
        expect_done(session, Drag{.moves = {{from, from + Vec3{0.1, 0, 0.3}}}, .fold_free = true});
        return session;
    };
    const Session exact = border(Setting::of(0.02)), usual = border(Setting::automatic());
    EXPECT_LT(largest_distance(exact.mesh(), usual.mesh()), 0.002);
}

}  // namespace
}  // namespace pectin

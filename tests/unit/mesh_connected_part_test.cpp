// The connected part of a surface inside a zone, and the face nearest to a point.
#include "mesh/connected_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

std::vector<FaceId> part_from(const TriMesh& mesh, std::uint32_t seed, const Box& zone) {
    const auto faces = FaceTree(mesh).faces_meeting(zone, mesh);
    const std::vector<FaceId> seeds{FaceId{seed}};
    return connected_part(mesh, faces, seeds, std::vector{zone}).faces;
}

// Two triangles that share only vertex 2, at the origin.
const std::string kBowTie = "v -1 -1 0\nv -1 1 0\nv 0 0 0\nv 1 1 0\nv 1 -1 0\nf 1 3 2\nf 3 5 4\n";

TEST(ConnectedPart, ReachesAcrossAVertexInTheZoneThatTwoSheetsShare) {
    const TriMesh mesh = test::mesh_of(kBowTie);
    EXPECT_EQ(part_from(mesh, 0, {Vec3{-2}, Vec3{2}}).size(), 2u);
}

// The shared vertex is outside the zone; each triangle has another corner inside.
TEST(ConnectedPart, DoesNotReachAcrossAVertexOutsideTheZone) {
    const TriMesh mesh = test::mesh_of(
        "v 0 0 0\nv 2 0 0\nv 2 0.1 0\nv 2 1 0\nv 2 1.1 0\n"
        "f 1 2 3\nf 1 4 5\n");
    const Box zone{{1, -1, -1}, {3, 2, 1}};
    EXPECT_EQ(part_from(mesh, 0, zone), std::vector{FaceId{0}});
    EXPECT_EQ(part_from(mesh, 1, zone), std::vector{FaceId{1}});
}

// All corners are outside; the common edge passes through the zone.
TEST(ConnectedPart, ReachesAcrossAnEdgeThatOnlyPassesThroughTheZone) {
    const TriMesh mesh = test::mesh_of("v -5 0 0\nv 5 0 0\nv 0 5 0\nv 0 -5 0\nf 1 2 3\nf 2 1 4\n");
    const Box zone{Vec3{-0.5}, Vec3{0.5}};
    EXPECT_EQ(part_from(mesh, 0, zone).size(), 2u);
    const Box beside{{-0.5, 0.5, -0.5}, {0.5, 1.0, 0.5}};
    EXPECT_EQ(part_from(mesh, 0, beside).size(), 1u);
    EXPECT_TRUE(part_from(mesh, 1, beside).empty());
}

TEST(ConnectedPart, OfATubeCutByTheZoneIsTheSideOfTheSeed) {
    const TriMesh mesh = build_mesh(make_shape(ShapeKind::torus, 12)).mesh;
    const Box slab{{-2, -2, -0.2}, {2, 2, 0.2}};
    const auto faces = FaceTree(mesh).faces_meeting(slab, mesh);
    const FaceId seed = faces.front();
    const auto part = part_from(mesh, index(seed), slab);
    EXPECT_GT(part.size(), 0u);
    EXPECT_LT(part.size(), faces.size());
    const auto side = [&](FaceId f) {
        return mesh.position(mesh.origin(TriMesh::half_edge(f, 0))).x > 0.0;
    };
    std::size_t same_side = 0;
    for (const FaceId f : faces) same_side += side(f) == side(seed) ? 1 : 0;
    EXPECT_EQ(part.size(), same_side);
    for (const FaceId f : part) EXPECT_EQ(side(f), side(seed));
}

// The definition, one step after another.
std::vector<FaceId> reached_step_by_step(const TriMesh& mesh, const std::vector<FaceId>& faces,
                                         FaceId seed, std::span<const Box> zones) {
    const auto any_zone = [&](auto test) { return std::ranges::any_of(zones, test); };
    std::map<std::pair<VertexId, VertexId>, std::vector<FaceId>> faces_at;
    std::map<FaceId, std::vector<std::pair<VertexId, VertexId>>> elements_of;
    for (const FaceId f : faces) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(f, corner);
            const VertexId v = mesh.origin(h), w = mesh.target(h);
            const Vec3 &a = mesh.position(v), &b = mesh.position(w);
            if (any_zone([&](const Box& zone) { return zone.contains_strictly(a); }))
                elements_of[f].push_back({v, v});
            if (any_zone([&](const Box& zone) { return triangle_meets_box(a, b, b, zone); }))
                elements_of[f].push_back({std::min(v, w), std::max(v, w)});
        }
        for (const auto& element : elements_of[f]) faces_at[element].push_back(f);
    }
    std::set<FaceId> reached;
    std::vector<FaceId> waiting;
    if (std::ranges::binary_search(faces, seed)) waiting.push_back(seed);
    while (!waiting.empty()) {
        const FaceId f = waiting.back();
        waiting.pop_back();
        if (!reached.insert(f).second) continue;
        for (const auto& element : elements_of[f]) {
            waiting.insert(waiting.end(), faces_at[element].begin(), faces_at[element].end());
        }
    }
    return {reached.begin(), reached.end()};
}

TEST(ConnectedPart, IsWhatStepsFromTheSeedReach) {
    constexpr std::uint64_t kSeed = 113;
    test::Random random(kSeed);
    for (int round = 0; round < test::case_count(200); ++round) {
        const TriMesh mesh = test::random_mesh(random).mesh;
        std::vector<Box> zones;
        for (int i = random.integer(1, 3); i > 0; --i) {
            const Vec3 centre = random.scale(0.05, 1.0) * random.direction();
            const Vec3 half = random.scale(0.02, 0.8) * (glm::abs(random.direction()) + Vec3{0.1});
            zones.push_back({centre - half, centre + half});
        }
        std::vector<FaceId> faces;
        for (const FaceId f : test::live_faces(mesh)) {
            const HalfEdgeId h = TriMesh::half_edge(f, 0);
            const Vec3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.target(h)),
                       &c = mesh.position(mesh.origin(TriMesh::prev(h)));
            const auto meets = [&](const Box& zone) { return triangle_meets_box(a, b, c, zone); };
            if (std::ranges::any_of(zones, meets)) faces.push_back(f);
        }
        if (faces.empty()) continue;
        const FaceId seed =
            faces[static_cast<std::size_t>(random.integer(0, static_cast<int>(faces.size()) - 1))];
        const ConnectedPart part = connected_part(mesh, faces, std::vector{seed}, zones);
        EXPECT_EQ(part.faces, reached_step_by_step(mesh, faces, seed, zones))
            << "seed " << kSeed << ", round " << round;
        std::vector<FaceId> all;
        std::ranges::merge(part.faces, part.others, std::back_inserter(all));
        EXPECT_EQ(all, faces) << "seed " << kSeed << ", round " << round;
    }
}

// With so many faces several threads join the sets.
TEST(ConnectedPart, IsTheSameOnSeveralThreads) {
    const TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 6)).mesh;
    const std::vector<FaceId> faces = test::live_faces(mesh);
    const std::vector<Box> two_caps{{{-2, -2, 0.3}, {2, 2, 2}}, {{-2, -2, -2}, {2, 2, -0.3}}};
    std::vector<FaceId> in_caps;
    for (const Box& cap : two_caps) {
        const auto there = FaceTree(mesh).faces_meeting(cap, mesh);
        in_caps.insert(in_caps.end(), there.begin(), there.end());
    }
    std::ranges::sort(in_caps);
    const FaceId seed = in_caps.front();
    const ConnectedPart part = connected_part(mesh, in_caps, std::vector{seed}, two_caps);
    EXPECT_EQ(part.faces.size(), part.others.size());
    EXPECT_EQ(part.faces, reached_step_by_step(mesh, in_caps, seed, two_caps));
    const std::vector<Box> everything{{Vec3{-2}, Vec3{2}}};
    EXPECT_EQ(connected_part(mesh, faces, std::vector{seed}, everything).faces, faces);
}

TEST(FaceTree, FindsTheNearestFaceAsBruteForceDoes) {
    test::Random random(111);
    for (int round = 0; round < test::case_count(20); ++round) {
        const TriMesh mesh = test::random_mesh(random).mesh;
        const FaceTree tree(mesh);
        for (int i = 0; i < 20; ++i) {
            const Vec3 p = random.scale(0.01, 3.0) * random.direction();
            double least = 1e300;
            for (const FaceId f : test::live_faces(mesh)) {
                const HalfEdgeId h = TriMesh::half_edge(f, 0);
                const Vec3 q = nearest_on_triangle(p, mesh.position(mesh.origin(h)),
                                                   mesh.position(mesh.target(h)),
                                                   mesh.position(mesh.origin(TriMesh::prev(h))));
                least = std::min(least, glm::distance(p, q));
            }
            const HalfEdgeId h = TriMesh::half_edge(*tree.nearest(p, mesh), 0);
            const Vec3 found =
                nearest_on_triangle(p, mesh.position(mesh.origin(h)), mesh.position(mesh.target(h)),
                                    mesh.position(mesh.origin(TriMesh::prev(h))));
            EXPECT_NEAR(glm::distance(p, found), least, 1e-12) << "seed 111, round " << round;
        }
    }
}

TEST(NearestOnTriangle, IsNearerThanAnySampleOfIt) {
    test::Random random(112);
    for (int round = 0; round < 500; ++round) {
        const Vec3 a = random.direction(), b = random.direction(), c = random.direction();
        const Vec3 p = random.scale(0.1, 3.0) * random.direction();
        const double nearest = glm::distance(p, nearest_on_triangle(p, a, b, c));
        double sampled = 1e300;
        for (int i = 0; i < 300; ++i) {
            const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
            sampled = std::min(sampled, glm::distance(p, u * a + v * b + (1 - u - v) * c));
        }
        EXPECT_LE(nearest, sampled + 1e-12);
        EXPECT_GE(nearest, sampled - 0.3);
    }
}

}  // namespace
}  // namespace pectin

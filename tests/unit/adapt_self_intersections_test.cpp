// Self-intersections of a few triangles by gesture, and of many against a test of all pairs.
#include "adapt/self_intersections.h"

#include <gtest/gtest.h>

#include <iostream>

#include "adapt/adapt.h"
#include "geometry/piercing.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::edge_between;
using test::mesh_of;

const Box kEverywhere{.min = Vec3{-9.0}, .max = Vec3{9.0}};

// A gesture in which the whole mesh is active.
struct ActiveGesture {
    explicit ActiveGesture(TriMesh made) : mesh(std::move(made)), active(mesh) {
        const std::vector<FaceId> faces = test::live_faces(mesh);
        active.begin(faces, kEverywhere);
    }
    void move(std::uint32_t v, const Vec3& to) { mesh.set_position(VertexId{v}, to); }
    TriMesh mesh;
    ActiveSet active;
};

const std::string kSheet = "v 0 0 0\nv 2 0 0\nv 0 2 0\n";

TEST(SelfIntersections, AreEdgesThroughFacesThatWereDisjointAtRest) {
    ActiveGesture gesture(
        mesh_of(kSheet + "v 0.5 0.5 1\nv 0.5 1 1\nv 1 0.5 1\nf 1 2 3\nf 4 5 6\n"));
    EXPECT_TRUE(SelfIntersections(gesture.active).find().empty());
    gesture.move(3, {0.5, 0.5, -1});
    const std::vector<SelfIntersection> expected{{edge_between(gesture.mesh, 3, 4), FaceId{0}},
                                                 {edge_between(gesture.mesh, 3, 5), FaceId{0}}};
    EXPECT_EQ(SelfIntersections(gesture.active).find(), expected);
    gesture.active.roll_back();
    gesture.active.finish();
}

TEST(SelfIntersections, ExcludeContactsAndIntersectionsAtRest) {
    // The second triangle touches the border of the first; the third passes through it at rest.
    ActiveGesture gesture(
        mesh_of(kSheet + "v 0.5 0 0\nv 1.5 0 0\nv 1 0 1\n"
                         "v 0.5 0.5 -1\nv 0.5 0.5 1\nv 3 3 3\nf 1 2 3\nf 4 5 6\nf 7 8 9\n"));
    EXPECT_TRUE(SelfIntersections(gesture.active).find().empty());
    gesture.move(3, {0.5, 0.4, -0.1});
    gesture.move(4, {1.5, 0.2, 0.1});
    EXPECT_TRUE(SelfIntersections(gesture.active).find().empty());
    gesture.active.roll_back();
    gesture.active.finish();
}

TEST(SelfIntersections, AreFoundBetweenFacesThatShareACorner) {
    ActiveGesture gesture(mesh_of(kSheet + "v -2 1 0\nv -2 -1 0\nf 1 2 3\nf 1 4 5\n"));
    gesture.move(3, {0.5, 0.5, 1});
    gesture.move(4, {0.5, 0.5, -1});
    const std::vector<SelfIntersection> expected{{edge_between(gesture.mesh, 3, 4), FaceId{0}}};
    EXPECT_EQ(SelfIntersections(gesture.active).find(), expected);
    gesture.active.roll_back();
    gesture.active.finish();
}

// The inserted vertex lies above a spike. Without the vertex, the spike would pass through the
// sheet.
TEST(SelfIntersections, ArePredictedForAnUnsplit) {
    for (const double height : {0.05, 0.5}) {
        ActiveGesture gesture(
            mesh_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                    "v 0.55 0.5 -1\nv 0.55 0.52 -1\nv 0.55 0.51 -0.1\n"
                    "f 1 2 3\nf 3 2 4\nf 5 6 7\n"));
        gesture.active.split(edge_between(gesture.mesh, 1, 2));
        const VertexId m{7};
        ASSERT_TRUE(gesture.mesh.is_live(m));
        gesture.mesh.set_position(m, {0.5, 0.5, height + 0.1});
        gesture.move(6, {0.55, 0.51, height});
        SelfIntersections intersections(gesture.active);
        EXPECT_TRUE(intersections.find().empty());
        EXPECT_TRUE(intersections.would_intersect(*gesture.mesh.removable(m)));
        gesture.move(6, {0.55, 0.51, -0.01});
        EXPECT_FALSE(SelfIntersections(gesture.active).would_intersect(*gesture.mesh.removable(m)));
        gesture.active.roll_back();
        gesture.active.finish();
    }
}

std::vector<SelfIntersection> intersections_by_scan(const ActiveSet& active) {
    const TriMesh& mesh = active.mesh();
    std::vector<SelfIntersection> intersections;
    for (EdgeId e : test::live_edges(mesh)) {
        const VertexId p = mesh.origin(mesh.half_edge(e)), q = mesh.target(mesh.half_edge(e));
        for (FaceId f : test::live_faces(mesh)) {
            const HalfEdgeId h = TriMesh::half_edge(f, 0);
            const VertexId v[] = {mesh.origin(h), mesh.target(h), mesh.origin(TriMesh::prev(h))};
            if (std::any_of(v, v + 3, [&](VertexId c) { return c == p || c == q; })) continue;
            const auto rest = [&](VertexId c) { return active.rest_position(c); };
            if (pierces(mesh.position(p), mesh.position(q), mesh.position(v[0]),
                        mesh.position(v[1]), mesh.position(v[2])) &&
                std::sqrt(squared_distance(rest(p), rest(q), rest(v[0]), rest(v[1]), rest(v[2]))) >
                    1e-9 * glm::distance(rest(p), rest(q))) {
                intersections.push_back({e, f});
            }
        }
    }
    return intersections;
}

// Long drags that fold space cause many intersections, before and after refinement.
TEST(SelfIntersections, MatchBruteForceBeforeAndAfterEdits) {
    std::size_t found = 0;
    const std::uint64_t count = static_cast<std::uint64_t>(test::case_count(40));
    for (std::uint64_t seed = 7400; seed < 7400 + count; ++seed) {
        test::Random random(seed);
        auto [mesh, description] = test::random_mesh(random);
        if (mesh.face_count() > 400) continue;
        Warp warp = test::random_warp(mesh, random);
        for (Vec3& d : std::get<DragStep>(warp.steps.back()).displacements) d *= 3.0;
        ActiveSet active(mesh);
        active.begin(test::live_faces(mesh), warp.zone());
        Embedding embedding(active, warp);
        embedding.embed();
        embedding.deform();
        const Criteria criteria(
            AdaptLimits{.floor = 0.01 * mesh.bounding_box().diagonal(), .budget = 1000},
            std::optional<Box>(), std::optional<Box>());
        SelfIntersections intersections(active);
        for (int round = 0; round < 4; ++round) {
            const std::vector<SelfIntersection> now = intersections.find();
            found += now.size();
            ASSERT_EQ(now, intersections_by_scan(active)) << description << ", seed " << seed;
            refine_at(active, embedding, criteria,
                      edges_to_resolve(active, embedding, criteria, now));
        }
        active.roll_back();
        active.finish();
    }
    std::cout << "self-intersections in seeds 7400 to " << 7399 + count << ": " << found << "\n";
    EXPECT_GT(found, 2 * count);
}

}  // namespace
}  // namespace pectin

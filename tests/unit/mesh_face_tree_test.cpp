// The face tree gives the same results as brute force after all kinds of edits.
#include "mesh/face_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "mesh/build_mesh.h"
#include "mesh/leaf_boxes.h"
#include "mesh/mesh_change.h"
#include "mesh/shapes.h"
#include "session/gesture.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

std::vector<FaceId> faces_meeting_by_scan(const Box& box, const TriMesh& mesh) {
    std::vector<FaceId> faces;
    for (FaceId f : test::live_faces(mesh)) {
        const HalfEdgeId h = TriMesh::half_edge(f, 0);
        if (triangle_meets_box(mesh.position(mesh.origin(h)), mesh.position(mesh.target(h)),
                               mesh.position(mesh.origin(TriMesh::prev(h))), box)) {
            faces.push_back(f);
        }
    }
    return faces;
}

Box random_query(const TriMesh& mesh, Random& random) {
    const Box all = mesh.bounding_box();
    const Vec3 fraction{random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2),
                        random.uniform(-0.2, 1.2)};
    const Vec3 centre = all.min + fraction * all.extent();
    const Vec3 half = all.diagonal() * random.scale(0.001, 1.0) *
                      Vec3{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    return {.min = centre - half, .max = centre + half};
}

void expect_agreement(const FaceTree& tree, const TriMesh& mesh, Random& random) {
    for (int i = 0; i < 25; ++i) {
        const Box box = random_query(mesh, random);
        ASSERT_EQ(tree.faces_meeting(box, mesh), faces_meeting_by_scan(box, mesh));
    }
    const Box all = mesh.bounding_box();
    ASSERT_EQ(tree.faces_meeting(all, mesh), test::live_faces(mesh));
}

Box box_of(const TriMesh& mesh, FaceId f) {
    Box box;
    for (int c = 0; c < 3; ++c) box.include(mesh.position(mesh.origin(TriMesh::half_edge(f, c))));
    return box;
}

// Sorted, with the lower id first.
std::vector<std::pair<FaceId, FaceId>> near_pairs(const FaceTree& tree, const TriMesh& mesh) {
    std::vector<std::pair<FaceId, FaceId>> pairs;
    const LeafBoxes boxes(tree, mesh);
    tree.for_near_leaves([&](std::span<const FaceTree::LeafPair> leaves) {
        for (const FaceTree::LeafPair& pair : leaves) {
            boxes.for_near_pairs(pair, [&](FaceId f, FaceId g) {
                pairs.emplace_back(std::min(f, g), std::max(f, g));
            });
        }
        return true;
    });
    std::ranges::sort(pairs);
    return pairs;
}

TEST(FaceTree, PairsFacesWhoseBoxesMeet) {
    for (std::uint64_t seed = 7500; seed < 7530; ++seed) {
        Random random(seed);
        const TriMesh mesh = test::random_mesh(random).mesh;
        if (mesh.face_count() > 2000) continue;
        std::vector<FaceId> some;
        for (FaceId f : test::live_faces(mesh)) {
            if (random.chance(0.6)) some.push_back(f);
        }
        const FaceTree tree(mesh, some);
        std::vector<std::pair<FaceId, FaceId>> expected;
        for (std::size_t i = 0; i < some.size(); ++i) {
            std::vector<FaceId> near;
            tree.append_near(box_of(mesh, some[i]), mesh, near);
            std::sort(near.begin(), near.end());
            std::vector<FaceId> met;
            for (std::size_t j = 0; j < some.size(); ++j) {
                if (!box_of(mesh, some[i]).meets(box_of(mesh, some[j]))) continue;
                met.push_back(some[j]);
                if (j > i) expected.emplace_back(some[i], some[j]);
            }
            ASSERT_EQ(near, met) << "seed " << seed;
        }
        const auto found = near_pairs(tree, mesh);
        ASSERT_TRUE(std::ranges::includes(found, expected)) << "seed " << seed;
        ASSERT_EQ(std::ranges::adjacent_find(found), found.end()) << "seed " << seed;
        // Others nearly meet, since boxes are rounded.
        const double rounding = 1e-8 * mesh.bounding_box().diagonal();
        for (const auto& [f, g] : found) {
            Box box = box_of(mesh, f);
            box.min -= Vec3{rounding};
            box.max += Vec3{rounding};
            ASSERT_TRUE(box.meets(box_of(mesh, g))) << "seed " << seed;
        }
    }
}

// Of coordinates near the largest number, near the smallest, in a plane, and with one far vertex.
TEST(LeafBoxes, MissNoPairWhateverTheCoordinates) {
    const auto scaled = [](double factor) {
        return [factor](const Vec3& p) { return factor * p; };
    };
    const auto flat = [](const Vec3& p) { return Vec3{p.x, 0.0, p.z}; };
    const std::vector<std::function<Vec3(const Vec3&)>> maps{scaled(1e308), scaled(1e-308),
                                                             scaled(1e-320), flat, scaled(1.0)};
    for (const auto& map : maps) {
        TriMesh mesh = build_mesh(make_shape(ShapeKind::torus, 6)).mesh;
        for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
            mesh.set_position(VertexId{v}, map(mesh.position(VertexId{v})));
        }
        if (&map == &maps.back()) mesh.set_position(VertexId{0}, Vec3{1e30, 0.0, 0.0});
        const FaceTree tree(mesh);
        std::vector<std::pair<FaceId, FaceId>> expected;
        const std::vector<FaceId> faces = test::live_faces(mesh);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            for (std::size_t j = i + 1; j < faces.size(); ++j) {
                if (box_of(mesh, faces[i]).meets(box_of(mesh, faces[j])))
                    expected.emplace_back(faces[i], faces[j]);
            }
        }
        EXPECT_TRUE(std::ranges::includes(near_pairs(tree, mesh), expected));
    }
}

// A part of a tree that was built before the vertices moved.
TEST(FaceTree, APartOfAnotherTreeMatchesBruteForceWhereTheFacesAreNow) {
    for (std::uint64_t seed = 700; seed < 740; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        const FaceTree whole(mesh);
        std::vector<FaceId> some;
        for (FaceId f : test::live_faces(mesh)) {
            if (random.chance(0.4)) some.push_back(f);
        }
        const double size = mesh.bounding_box().diagonal();
        for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
            mesh.set_position(VertexId{v},
                              mesh.position(VertexId{v}) + 0.05 * size * random.direction());
        }
        const FaceTree part(whole, mesh, some), built(mesh, some);
        for (int i = 0; i < 20; ++i) {
            const Vec3 at = mesh.bounding_box().centre() + 0.5 * size * random.direction();
            const double extent = size * random.scale(0.01, 0.5);
            const Box box{.min = at - Vec3{extent}, .max = at + Vec3{extent}};
            ASSERT_EQ(part.faces_meeting(box, mesh), built.faces_meeting(box, mesh));
            ASSERT_EQ(part.nearest(at, mesh), built.nearest(at, mesh));
        }
        ASSERT_EQ(near_pairs(part, mesh), near_pairs(built, mesh));
    }
}

MeshChange random_gesture(TriMesh& mesh, const FaceTree& tree, Random& random) {
    const Warp warp = test::random_warp(mesh, random);
    const Box zone = warp.zone();
    const double diagonal = mesh.bounding_box().diagonal();
    ActiveSet active(mesh);
    const double theta = random.scale(3.0, 60.0);
    Gesture gesture(
        active, {.moving = tree.faces_meeting(zone, mesh)}, warp,
        Gesture::Adaptivity{AdaptLimits{
            .curvature = NormalDivergence({.theta_max = theta, .theta_min = 0.7 * theta}),
            .l_max = warp.smallest_feature_extent(),
            .floor = 0.02 * diagonal}});
    return gesture.commit(std::get<DragStep>(warp.steps.back()).displacements);
}

TEST(FaceTree, MatchesBruteForceThroughGesturesUndoAndRedo) {
    const int cases = test::case_count(60);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 3000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        FaceTree tree(mesh);
        expect_agreement(tree, mesh, random);
        std::vector<MeshChange> done;
        for (int gesture = 0; gesture < 4; ++gesture) {
            done.push_back(random_gesture(mesh, tree, random));
            tree.update(done.back().faces, mesh);
            expect_agreement(tree, mesh, random);
        }
        for (std::size_t k = done.size(); k-- > 0;) {
            undo(done[k], mesh);
            tree.update(done[k].faces, mesh);
            expect_agreement(tree, mesh, random);
        }
        for (const MeshChange& change : done) {
            redo(change, mesh);
            tree.update(change.faces, mesh);
            expect_agreement(tree, mesh, random);
        }
        if (HasFailure()) return;
    }
}

TEST(FaceTree, StaysCorrectAfterFarMoreSplitsThanItsInitialFaces) {
    Random random(4);
    TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 1)).mesh;
    FaceTree tree(mesh);
    for (int i = 0; i < 600; ++i) {
        const auto edges = test::live_edges(mesh);
        const EdgeId e =
            edges[static_cast<std::size_t>(random.integer(0, static_cast<int>(edges.size()) - 1))];
        const HalfEdgeId h = mesh.half_edge(e), twin = mesh.twin(h);
        const Split s = mesh.split(e);
        tree.update(std::vector<FaceId>{TriMesh::face(h), TriMesh::face(twin), s.face3, s.face4},
                    mesh);
        if (i % 20 == 0) expect_agreement(tree, mesh, random);
    }
    EXPECT_GT(mesh.face_count(), 8u * 80u);
    expect_agreement(tree, mesh, random);
}

TEST(FaceTree, IsUpdatedForFacesThatMoveWithoutEdits) {
    Random random(5);
    TriMesh mesh = build_mesh(make_shape(ShapeKind::torus, 6)).mesh;
    FaceTree tree(mesh);
    for (int i = 0; i < 200; ++i) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
        mesh.set_position(v, mesh.position(v) + random.uniform(0.0, 2.0) * random.direction());
        std::vector<FaceId> moved;
        for (FaceId f : test::live_faces(mesh)) {
            for (int c = 0; c < 3; ++c) {
                if (mesh.origin(TriMesh::half_edge(f, c)) == v) moved.push_back(f);
            }
        }
        tree.update(moved, mesh);
    }
    expect_agreement(tree, mesh, random);
}

TEST(FaceTree, FindsNothingInAMeshWithoutFaces) {
    const TriMesh mesh;
    const FaceTree tree(mesh);
    EXPECT_TRUE(tree.faces_meeting({.min = Vec3{-1.0}, .max = Vec3{1.0}}, mesh).empty());
}

TEST(FaceTree, FindsManyCoincidentFaces) {
    IndexedFaceSet set;  // more coincident triangles than any leaf holds
    set.parts.emplace_back();
    for (std::uint32_t i = 0; i < 100; ++i) {
        for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
            set.corners.push_back({.position = static_cast<std::uint32_t>(set.positions.size())});
            set.positions.push_back(p);
        }
        set.polygon_end.push_back(3 * (i + 1));
        set.polygon_part.push_back(0);
    }
    const TriMesh mesh = build_mesh(set).mesh;
    const FaceTree tree(mesh);
    EXPECT_EQ(tree.faces_meeting({.min = Vec3{0.1}, .max = Vec3{0.2}}, mesh).size(), 0u);
    EXPECT_EQ(tree.faces_meeting({.min = Vec3{0.0}, .max = Vec3{0.2}}, mesh).size(), 100u);
}

}  // namespace
}  // namespace pectin

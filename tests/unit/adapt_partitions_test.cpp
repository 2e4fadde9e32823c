// Concurrent splits and unsplits give the mesh that serial edits in their order give.
#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "adapt/adapt.h"
#include "adapt/concurrent/corner_claims.h"
#include "adapt/concurrent/splits.h"
#include "ffd/drag_solver.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/mesh_change.h"
#include "mesh/shapes.h"
#include "support/mesh_figures.h"
#include "support/test_run.h"

namespace pectin {
namespace {

const std::vector<std::string> kValid;
constexpr Box kAll{.min = Vec3{-10.0}, .max = Vec3{10.0}};

double mean_edge(const TriMesh& mesh) {
    double sum = 0.0;
    for (EdgeId e : test::live_edges(mesh)) sum += mesh.length(e);
    return sum / mesh.edge_count();
}

struct Scene {
    const char* name;
    ShapeKind shape;
    int resolution;
    Box zone;
    bool is_all_active = true;
    int steps = 0;               // of the warp
    bool is_mirrored = false;    // symmetric at x = 0, and refined so
    bool samples_steps = false;  // L_max only ensures that the steps of the warp are noticed
};
// The scenes have creases and texture coordinates, a border of the active set, symmetry, the steps
// of a long drag, two drags one after another, a smooth closed surface, a boundary, or one drag.
const Scene kScenes[] = {
    {"cube", ShapeKind::cube, 40, kAll},
    {"part of a sphere", ShapeKind::sphere, 5, {.min = Vec3{-0.7}, .max = Vec3{2.0}}, false},
    {"mirrored dragged sphere", ShapeKind::sphere, 5, kAll, true, 1, true},
    {"sphere dragged in sampled steps", ShapeKind::sphere, 5, kAll, true, 3, false, true},
    {"sphere dragged twice", ShapeKind::sphere, 5, kAll, true, 2},
    {"sphere", ShapeKind::sphere, 5, kAll},
    {"plane", ShapeKind::plane, 100, kAll},
    {"dragged sphere", ShapeKind::sphere, 5, kAll, true, 1},
    {"mirrored sphere", ShapeKind::sphere, 5, kAll, true, 0, true},
    {"mirrored cube", ShapeKind::cube, 40, kAll, true, 0, true},
};

// Sanitizers slow the scenes down by a factor of 10 to 30, so with them only the first few are run.
std::span<const Scene> scenes() {
    return std::span(kScenes).first(test::is_sanitized() ? 4 : std::size(kScenes));
}

TriMesh mesh_of(const Scene& scene) {
    return build_mesh(make_shape(scene.shape, scene.resolution)).mesh;
}

Warp warp_of(const Scene& scene) {
    Warp warp;
    warp.moves_middles_most = scene.samples_steps;
    const Vec3 grabbed{0, 0, 1};
    const auto solver =
        std::get<DragSolver>(DragSolver::create(brush_lattice(grabbed, 4.0, 3), {&grabbed, 1}, {}));
    for (int step = 0; step < scene.steps; ++step) {
        const double across = scene.is_mirrored ? 0.0 : 0.1;
        warp.steps.push_back(DragStep{solver.field(), {Vec3{across, 0.2 * step, 0.3}}});
    }
    return warp;
}

std::optional<MirrorPlane> symmetry_of(const Scene& scene) {
    return scene.is_mirrored ? std::optional(MirrorPlane{}) : std::nullopt;
}

// The mesh of a scene, deformed by its warp. The faces that meet the scene's zone are active.
class Refined {
  public:
    explicit Refined(const Scene& scene)
        : scene_(scene), mesh_(mesh_of(scene)), active_(mesh_), warp_(warp_of(scene)) {
        active_.begin(FaceTree(mesh_).faces_meeting(scene.zone, mesh_), scene.zone);
        embedding_ = std::make_unique<Embedding>(active_, warp_);
        embedding_->embed();
        embedding_->deform();
    }
    Refinement refine(AdaptLimits limits) {
        limits.symmetry = symmetry_of(scene_);
        limits.l_max_is_automatic = scene_.samples_steps;
        if (scene_.samples_steps) {
            limits.curvature = NormalDivergence({.theta_max = 20.0, .theta_min = 15.0});
        }
        const Criteria criteria(limits, {scene_.zone}, std::vector{scene_.zone},
                                scene_.samples_steps ? embedding_.get() : nullptr);
        EXPECT_EQ(criteria.length().limits_result(), !scene_.samples_steps);
        return pectin::refine(active_, *embedding_, criteria);
    }
    Decimation decimate(const AdaptLimits& limits) {
        return pectin::decimate(active_, Criteria(limits, scene_.zone, scene_.zone));
    }
    void deform() { embedding_->deform(); }
    MeshChange finish() { return active_.finish(); }

    TriMesh& mesh() { return mesh_; }
    ActiveSet& active() { return active_; }
    Embedding& embedding() { return *embedding_; }

  private:
    const Scene& scene_;
    TriMesh mesh_;
    ActiveSet active_;
    Warp warp_;
    std::unique_ptr<Embedding> embedding_;
};

AdaptLimits half_of(const TriMesh& mesh) { return {.l_max = 0.5 * mean_edge(mesh), .floor = 1e-6}; }

TEST(Partitions, GiveTheSameMeshAsSerialEdits) {
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        const TriMesh before = mesh_of(scene);
        Refined refined(scene);
        const AdaptLimits half = half_of(before);
        const Refinement halved = refined.refine(half);
        EXPECT_GT(halved.concurrent_splits, halved.splits / 2);
        EXPECT_EQ(refined.mesh().validate(), kValid);
        for (EdgeId e : refined.active().edges()) {
            const auto in_zone = [&](HalfEdgeId h) {
                return scene.zone.contains(refined.mesh().position(refined.mesh().origin(h)));
            };
            if (in_zone(refined.mesh().half_edge(e)) && !scene.samples_steps) {
                EXPECT_LE(refined.mesh().length(e), half.l_max);
            }
        }
        const double half_again = 0.7 * half.l_max;
        refined.decimate({.l_max = 1.5 * half.l_max});
        EXPECT_EQ(refined.mesh().validate(), kValid);
        // These splits use slots that the unsplits have freed.
        EXPECT_GT(refined.refine({.l_max = half_again, .floor = 1e-6}).concurrent_splits, 10'000u);
        EXPECT_EQ(refined.mesh().validate(), kValid);
        EXPECT_GT(refined.decimate({.l_max = half.l_max}).concurrent_unsplits, 4096u);
        EXPECT_EQ(refined.mesh().validate(), kValid);

        // Inserted vertices lie where deforming the whole active set takes them.
        const TriMesh embedded = refined.mesh();
        refined.deform();
        EXPECT_TRUE(refined.mesh() == embedded);

        // The log of edits repeats them one after another, and undoes them.
        const MeshChange change = refined.finish();
        TriMesh again = before;
        redo(change, again);
        EXPECT_TRUE(again == refined.mesh());
        undo(change, refined.mesh());
        EXPECT_TRUE(refined.mesh() == before);
    }
}

// Short batches are tested, too, because their partitions border on each other in many places.
TEST(Partitions, KeepAMirroredMeshMirrored) {
    for (const Scene& scene : scenes()) {
        if (!scene.is_mirrored) continue;
        for (const std::size_t partition_batch : {kPartitionBatch, std::size_t{60}}) {
            SCOPED_TRACE(scene.name + (", " + std::to_string(partition_batch)));
            Refined refined(scene);
            AdaptLimits half = half_of(refined.mesh());
            half.partitioning.batch = partition_batch;
            ASSERT_LT(test::asymmetry(refined.mesh()), 1e-9);
            const Refinement halved = refined.refine(half);
            EXPECT_GT(halved.concurrent_splits, halved.splits / 2);
            EXPECT_LT(test::asymmetry(refined.mesh()), 1e-9);
            half.l_max *= 0.7;
            refined.refine(half);
            EXPECT_LT(test::asymmetry(refined.mesh()), 1e-9);
            refined.finish();
        }
    }
}

TEST(Partitions, UndoAllSplitsWithAllLimitsOff) {
    for (const Scene& scene : scenes()) {
        if (!scene.is_all_active) continue;  // splits beyond the scope are not undone
        if (scene.steps > 0) continue;       // base vertices have moved
        SCOPED_TRACE(scene.name);
        const TriMesh before = mesh_of(scene);
        Refined refined(scene);
        const std::uint64_t splits = refined.refine(half_of(before)).splits;
        EXPECT_EQ(refined.decimate({}).unsplits, splits);
        EXPECT_EQ(refined.mesh().vertex_count(), before.vertex_count());
        EXPECT_EQ(refined.mesh().face_count(), before.face_count());
        EXPECT_EQ(refined.mesh().validate(), kValid);
        EXPECT_TRUE(refined.mesh().baked() == before.baked());
        refined.active().finish();
    }
}

// The comparison includes free lists and logs.
TEST(Partitions, GiveTheSameBytesOnAnyNumberOfThreads) {
    const auto refined_on = [](const Scene& scene, int threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(threads));
        tbb::task_arena arena(threads);
        return arena.execute([&] {
            Refined refined(scene);
            const AdaptLimits half = half_of(refined.mesh());
            refined.refine(half);
            refined.decimate({.l_max = 1.2 * half.l_max});
            refined.refine({.l_max = 0.8 * half.l_max, .floor = 1e-6});
            std::vector<FaceId> faces(refined.active().faces().begin(),
                                      refined.active().faces().end());
            return std::tuple(refined.mesh(), std::move(faces), refined.finish().edits);
        });
    };
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        const auto one = refined_on(scene, 1);
        const auto counts = test::is_sanitized() ? std::vector{8} : std::vector{2, 2, 8, 8};
        for (const int threads : counts) {
            const auto many = refined_on(scene, threads);
            EXPECT_TRUE(std::get<0>(many) == std::get<0>(one));
            EXPECT_EQ(std::get<1>(many), std::get<1>(one));
            EXPECT_TRUE(std::get<2>(many) == std::get<2>(one));
        }
    }
}

TEST(Partitions, StayWithinTheBudget) {
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        const TriMesh before = mesh_of(scene);
        AdaptLimits limits = half_of(before);
        limits.budget = before.face_count() + 10'001;
        Refined refined(scene);
        EXPECT_TRUE(refined.refine(limits).budget_hit);
        EXPECT_LE(refined.mesh().face_count(), limits.budget);
        EXPECT_GE(refined.mesh().face_count() + 3, limits.budget);
        EXPECT_EQ(refined.mesh().validate(), kValid);
        refined.finish();
    }
}

// An accepted edge is the longest of its faces when its turn comes. All other edges are deferred:
// returned, or queued again.
TEST(ConcurrentSplits, SplitTheLongestEdgesOfTheirFacesAndDeferTheOthers) {
    for (const Scene& scene : scenes()) {
        if (scene.steps > 0) continue;  // at rest, lengths are those of the mesh
        SCOPED_TRACE(scene.name);
        Refined refined(scene);
        TriMesh in_turn = refined.mesh();
        AdaptLimits limits = half_of(refined.mesh());
        limits.symmetry = symmetry_of(scene);
        const Criteria criteria(limits, scene.zone, scene.zone);
        const EdgeClassifier classifier(refined.active(), criteria);
        RefinementQueue queue;
        for (EdgeId e : refined.active().edges()) {
            if (criteria.needs_refinement(refined.active(), e))
                queue.push(e, classifier.length_class_of(e));
        }
        const RefinementQueue::Batch next = queue.take();
        ASSERT_FALSE(next.is_serial);
        std::size_t needed = 0;
        for (const auto& partition : next.partitions) {
            for (EdgeId e : partition)
                needed += classifier.still_needs_split(e, next.length_class) ? 1 : 0;
        }
        ConcurrentSplits concurrent(refined.active(), refined.embedding(), classifier, limits);
        RefinementQueue queued;
        const ConcurrentSplits::Result done = concurrent.split(next, queued);
        std::size_t returned = 0;
        for (const PendingSplits& deferred : done.deferred) {
            returned += deferred.splits.size();
            for (const PendingSplit& split : deferred.splits)
                EXPECT_TRUE(refined.mesh().is_live(split.edge) &&
                            refined.mesh().is_live(split.end));
        }
        std::size_t queued_again = 0;
        for (; !queued.is_empty() && returned == 0;) {
            const RefinementQueue::Batch batch = queued.take();
            if (batch.length_class != next.length_class) break;
            for (const auto& partition : batch.partitions) queued_again += partition.size();
        }
        EXPECT_GE(done.splits + returned + queued_again, needed);
        EXPECT_GT(done.splits, needed / 4);
        EXPECT_EQ(refined.mesh().validate(), kValid);

        const MeshChange change = refined.finish();
        ASSERT_EQ(change.edits.size(), done.splits);
        for (const TopologyEdit edit : change.edits) {
            in_turn.for_each_side(edit.edge(), [&](HalfEdgeId h) {
                const double longest = (1.0 + 1e-6) * in_turn.length(edit.edge());
                EXPECT_LE(in_turn.length(in_turn.edge(TriMesh::next(h))), longest);
                EXPECT_LE(in_turn.length(in_turn.edge(TriMesh::prev(h))), longest);
            });
            in_turn.split(edit.edge());
        }
        EXPECT_TRUE(in_turn == refined.mesh());
    }
}

TEST(CornerClaims, GiveACornerToTheLowestPartitionOrToTheFirst) {
    const auto corners = [](std::uint32_t a, std::uint32_t b) {
        return CornerClaims::Corners{a, b, a, b};
    };
    CornerClaims claims;
    claims.begin(8);
    claims.claim(corners(0, 1), 2);
    claims.claim(corners(1, 2), 0);
    claims.claim(corners(2, 3), 1);
    EXPECT_FALSE(claims.are_owned_by(corners(0, 1), 2));
    EXPECT_TRUE(claims.are_owned_by(corners(0, 0), 2));
    EXPECT_TRUE(claims.are_owned_by(corners(1, 2), 0));
    EXPECT_FALSE(claims.are_owned_by(corners(2, 3), 1));
    claims.release(corners(1, 2));
    EXPECT_TRUE(claims.try_claim(corners(1, 4), 3));
    EXPECT_TRUE(claims.try_claim(corners(4, 1), 3));
    EXPECT_FALSE(claims.try_claim(corners(5, 4), 0));
    EXPECT_TRUE(claims.try_claim(corners(5, 5), 0));
    claims.begin(8);
    EXPECT_TRUE(claims.try_claim(corners(4, 5), 1));
}

}  // namespace
}  // namespace pectin

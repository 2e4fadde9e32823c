// The guarantees of adaptive meshing on random meshes, lattices, drags and thresholds. Coarse
// meshes with small thresholds matter most, since they break the published rules.
#include <gtest/gtest.h>

#include <algorithm>

#include "adapt/accumulated_error.h"
#include "mesh/face_tree.h"
#include "session/gesture.h"
#include "session/settings.h"
#include "support/random_mesh.h"
#include "support/test_run.h"
#include "support/triggers.h"

namespace pectin {
namespace {

using test::Random;
using Trigger = command::Adapt::Trigger;

// More than any case needs. Refinement that does not terminate ends here and fails.
constexpr std::uint64_t kBudget = 4'000'000;

AdaptLimits random_limits(Trigger trigger, const Warp& warp, double diagonal, Random& random) {
    AdaptSettings settings;
    settings.trigger = trigger;
    settings.budget = kBudget;
    settings.theta_max = Setting::of(random.scale(0.5, 60.0));
    if (random.chance(0.3)) {
        settings.theta_min = Setting::of(settings.theta_max.value * random.uniform(0.05, 0.999));
    }
    if (random.chance(0.3)) settings.l_max = Setting::off();
    if (random.chance(0.2)) {
        settings.l_max = Setting::of(warp.smallest_feature_extent() * random.scale(0.3, 3.0));
    }
    if (random.chance(0.1)) settings.theta_max = Setting::off();
    if (random.chance(0.2)) settings.flatness = Setting::of(random.scale(1e-3, 1.0));
    if (random.chance(0.1)) settings.flatness = Setting::off();
    if (random.chance(0.3)) settings.propagation = random.uniform(1.0, 1.49);
    // Short batches, so that small meshes are split concurrently, too.
    const int partition_batch = random.chance(0.6) ? random.integer(1, 8) : 512;
    // Small thresholds on large zones need millions of triangles; a floor keeps the cases small
    // and is itself part of what is tested.
    settings.floor = Setting::of(diagonal * random.scale(8e-3, 6e-2));
    if (trigger == Trigger::midpoint) {
        settings.tolerance = Setting::of(diagonal * random.scale(1e-5, 3e-2));
    }
    if (trigger == Trigger::certified) {
        settings.tolerance = Setting::of(diagonal * random.scale(2e-3, 1e-1));
    }
    const double extent = warp.smallest_feature_extent();
    AdaptLimits limits = random.chance(0.6) ? settings.drag_limits(extent, diagonal)
                                            : settings.limits(extent, diagonal);
    limits.partitioning.batch = static_cast<std::size_t>(partition_batch);
    return limits;
}

std::uint64_t active_edges_needing_refinement(const ActiveSet& active, const Criteria& criteria,
                                              const std::vector<EdgeId>& blocked) {
    std::uint64_t count = 0;
    for (EdgeId e : active.edges()) {
        const TriMesh& mesh = active.mesh();
        if (!mesh.is_live(e) || criteria.is_below_floor(mesh, e) || !mesh.may_split(e)) continue;
        if (std::find(blocked.begin(), blocked.end(), e) != blocked.end()) continue;
        if (criteria.needs_refinement(active, e)) ++count;
    }
    return count;
}

// Follows the chain from e to neighbours that are longer at rest and may be split. The last edge is
// rightly blocked if a longer edge of its faces is below the floor, and a split would make that
// face thinner than 1:512.
bool is_rightly_blocked(ActiveSet& active, const Criteria& criteria, EdgeId e) {
    const TriMesh& mesh = active.mesh();
    const double rho = criteria.limits().propagation;
    while (true) {
        EdgeId longest = e;
        bool thin = false;
        double length = rho * static_cast<double>(active.rest_length(e));
        for (HalfEdgeId side : {mesh.half_edge(e), mesh.twin(mesh.half_edge(e))}) {
            if (!exists(side)) continue;
            const Vec3 a = active.rest_position(mesh.origin(TriMesh::prev(side)));
            const Vec3 b = active.rest_position(mesh.origin(side));
            const Vec3 c = active.rest_position(mesh.target(side));
            for (HalfEdgeId other : {TriMesh::next(side), TriMesh::prev(side)}) {
                const EdgeId neighbour = mesh.edge(other);
                const double rest = static_cast<double>(active.rest_length(neighbour));
                if (rest <= rho * static_cast<double>(active.rest_length(e))) continue;
                if (criteria.is_below_floor(mesh, neighbour)) {
                    const double doubled_area = glm::length(glm::cross(b - a, c - a));
                    thin |= 0.5 * doubled_area < rest * rest / 512.0 * 1.001;
                } else if (rest > length) {
                    length = rest;
                    longest = neighbour;
                }
            }
        }
        if (longest == e) return thin;
        e = longest;
    }
}

// One gesture, which is adapted a second time before it ends.
MeshChange checked_gesture(TriMesh& mesh, const Warp& warp, const AdaptLimits& limits) {
    const Box zone = warp.zone();
    ActiveSet active(mesh);
    if (std::holds_alternative<CertifiedError>(limits.curvature)) mesh.track_errors();
    active.begin(FaceTree(mesh).faces_meeting(zone, mesh), zone);
    Embedding embedding(active, warp);
    embedding.embed();
    embedding.deform();
    const Criteria criteria(limits, zone, zone, &embedding);
    const Adaptation first = adapt(active, embedding, criteria);
    EXPECT_FALSE(first.refinement.budget_hit) << "ran away: " << first.refinement.splits;
    EXPECT_EQ(active_edges_needing_refinement(active, criteria, first.refinement.blocked), 0u);
    for (EdgeId e : first.refinement.blocked) {
        if (!mesh.is_live(e) || criteria.is_below_floor(mesh, e)) continue;
        EXPECT_TRUE(is_rightly_blocked(active, criteria, e)) << "edge " << index(e);
    }
    if (!first.refinement.budget_hit) {
        const Adaptation again = adapt(active, embedding, criteria);
        EXPECT_EQ(again.refinement.splits, 0u);
        EXPECT_EQ(again.decimation.unsplits, 0u);
    }
    accumulate_errors(active, criteria);
    return active.finish();
}

MeshChange interactive_gesture(TriMesh& mesh, const Warp& warp, const AdaptLimits& limits,
                               Random& random) {
    const Box zone = warp.zone();
    ActiveSet active(mesh);
    Gesture gesture(active, {.moving = FaceTree(mesh).faces_meeting(zone, mesh)}, warp,
                    Gesture::Adaptivity{limits});
    const std::vector<Vec3>& target = std::get<DragStep>(warp.steps.back()).displacements;
    const int frames = random.integer(1, 5);
    for (int i = 0; i < frames; ++i) {
        std::vector<Vec3> d;
        const double part = random.uniform(-0.5, 1.5);
        for (const Vec3& t : target) d.push_back(part * t);
        gesture.frame(d);
        EXPECT_EQ(mesh.validate(), std::vector<std::string>{});
    }
    return gesture.commit(target);
}

void expect_same_base(const TriMesh& mesh, const TriMesh& base) {
    ASSERT_EQ(mesh.face_count(), base.face_count());
    EXPECT_EQ(mesh.vertex_count(), base.vertex_count());
    EXPECT_EQ(mesh.edge_count(), base.edge_count());
    for (std::uint32_t f = 0; f < base.face_slots(); ++f) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(FaceId{f}, corner);
            ASSERT_EQ(mesh.half_edge(h), base.half_edge(h)) << "face " << f;
        }
    }
}

void decimate_to_base(TriMesh& mesh) {
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
        if (mesh.is_live(FaceId{f})) faces.push_back(FaceId{f});
    }
    ActiveSet active(mesh);
    active.begin(faces, Box{});
    const Warp none;
    Embedding embedding(active, none);
    adapt(active, embedding, Criteria(AdaptLimits{}, std::nullopt, std::nullopt));
    active.finish();
}

void run_case(Trigger trigger, std::uint64_t seed) {
    Random random(seed);
    auto [mesh, description] = test::random_mesh(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
    ASSERT_EQ(mesh.validate(), std::vector<std::string>{});
    const TriMesh base = mesh;
    const double diagonal = mesh.bounding_box().diagonal();
    const int gestures = random.integer(1, 4);
    for (int i = 0; i < gestures; ++i) {
        SCOPED_TRACE("gesture " + std::to_string(i));
        const Warp warp = test::random_warp(mesh, random);
        // A drag may stretch the object so far that this floor would be tiny.
        const double reach = reach_bound(warp.steps.front());
        const double size = std::max(diagonal, 0.25 * (mesh.bounding_box().diagonal() + reach));
        const AdaptLimits limits = random_limits(trigger, warp, size, random);
        const TriMesh before = mesh;
        const MeshChange change = checked_gesture(mesh, warp, limits);
        ASSERT_EQ(mesh.validate(), std::vector<std::string>{});
        const TriMesh after = mesh;

        undo(change, mesh);
        ASSERT_TRUE(mesh == before) << "undo differs";
        redo(change, mesh);
        ASSERT_TRUE(mesh == after) << "redo differs";

        TriMesh dragged = before;
        const MeshChange same = interactive_gesture(dragged, warp, limits, random);
        ASSERT_TRUE(dragged == after) << "frames, then commit, differ from a single commit";
        undo(same, dragged);
        ASSERT_TRUE(dragged == before) << "undo after frames differs";
        if (testing::Test::HasFailure()) return;
    }
    decimate_to_base(mesh);
    ASSERT_EQ(mesh.validate(), std::vector<std::string>{});
    expect_same_base(mesh, base);
}

class Adapt : public testing::TestWithParam<Trigger> {};

TEST_P(Adapt, TerminatesAtAFixedPointIsReversibleAndLeavesNothingToRefine) {
    if (const char* seed = std::getenv("PECTIN_TEST_SEED")) {
        return run_case(GetParam(), std::stoull(seed));
    }
    // A certificate takes longer.
    const int certified_cases = test::is_sanitized() ? 4 : 80;
    const int cases = test::case_count(GetParam() == Trigger::certified ? certified_cases : 400);
    for (int i = 0; i < cases; ++i) {
        run_case(GetParam(), 1000 + static_cast<std::uint64_t>(i));
        if (HasFailure()) {
            ADD_FAILURE() << "stopped at seed " << 1000 + i;
            return;
        }
    }
    std::printf("seeds 1000 to %d\n", 1000 + cases - 1);
}

INSTANTIATE_TEST_SUITE_P(By, Adapt,
                         testing::Values(Trigger::normals, Trigger::midpoint, Trigger::certified),
                         test::name_of_trigger);

}  // namespace
}  // namespace pectin

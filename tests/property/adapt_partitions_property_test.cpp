// Tests that concurrent edits give the same triangles as the serial reference on random input.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "adapt/adapt.h"
#include "ffd/drag_solver.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

using Point = std::array<double, 3>;
// The corners, and the error of the face.
using Triangle = std::pair<std::array<Point, 3>, std::array<float, 6>>;

// The triangles of a mesh and their errors in a form that does not depend on ids. They are sorted,
// and each begins with its least corner.
std::vector<Triangle> triangles(const TriMesh& mesh) {
    std::vector<Triangle> all;
    for (FaceId f : test::live_faces(mesh)) {
        std::array<Point, 3> triangle;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3& p = mesh.position(mesh.origin(TriMesh::half_edge(f, corner)));
            triangle[static_cast<std::size_t>(corner)] = {p.x, p.y, p.z};
        }
        std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
        all.emplace_back(triangle, mesh.error(f).entries());
    }
    std::ranges::sort(all);
    return all;
}

// A sphere, a plane with a boundary or a cube with creases. All edges have different lengths,
// because the order of splits decides between equal ones.
TriMesh irregular_shape(Random& random) {
    constexpr std::array kKinds{ShapeKind::sphere, ShapeKind::plane, ShapeKind::cube};
    const ShapeKind kind = kKinds[static_cast<std::size_t>(random.integer(0, 2))];
    IndexedFaceSet input =
        make_shape(kind, kind == ShapeKind::sphere ? random.integer(1, 3) : random.integer(2, 8));
    for (Vec3& p : input.positions) p += random.uniform(0.0, 0.03) * random.direction();
    return build_mesh(input).mesh;
}

struct Scene {
    TriMesh mesh;
    Warp warp;
    AdaptLimits refining, decimating;

    bool is_certified() const { return std::holds_alternative<CertifiedError>(refining.curvature); }
};

Scene random_scene(Random& random, bool is_certified) {
    TriMesh mesh = irregular_shape(random);
    const std::vector<Vec3> grabbed{mesh.position(VertexId{0})};
    auto solver = std::get<DragSolver>(
        DragSolver::create(brush_lattice(grabbed[0], random.scale(0.5, 4.0), 3), grabbed, {}));
    Warp warp{{DragStep{solver.field(), {random.uniform(0.0, 0.4) * random.direction()}}}};
    if (is_certified) {
        const double tolerance = random.scale(3e-4, 3e-3);
        return {std::move(mesh),
                std::move(warp),
                {.curvature = CertifiedError(tolerance), .floor = 1e-4},
                {.curvature = CertifiedError(3.0 * tolerance), .floor = 1e-4}};
    }
    const double theta_max = random.scale(4.0, 20.0), l_max = random.scale(0.05, 0.3);
    // The floor is so small that it blocks no edge. The splits beside a blocked edge would depend
    // on the order.
    const AdaptLimits refining{
        .curvature = NormalDivergence({.theta_max = theta_max}), .l_max = l_max, .floor = 1e-4};
    const AdaptLimits decimating{
        .curvature = NormalDivergence({.theta_max = 1.5 * theta_max, .theta_min = 1.2 * theta_max}),
        .l_max = 1.5 * l_max,
        .floor = 1e-4};
    return {std::move(mesh), std::move(warp), refining, decimating};
}

struct Outcome {
    std::vector<Triangle> refined, decimated;
    std::uint64_t splits = 0, unsplits = 0, concurrent_splits = 0, concurrent_unsplits = 0;
    bool floor_hit = false;
};

Outcome adapted(const Scene& scene, const Partitioning& partitioning) {
    TriMesh mesh = scene.mesh;
    const Box zone = scene.warp.zone();
    ActiveSet active(mesh);
    // Errors of an earlier gesture, so that it shows whether unsplits join them alike.
    if (scene.is_certified()) {
        mesh.track_errors();
        for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
            mesh.set_error(FaceId{f}, ErrorEllipsoid::ball(1e-5 * static_cast<double>(f % 7)));
        }
    }
    active.begin(FaceTree(mesh).faces_meeting(zone, mesh), zone);
    Embedding embedding(active, scene.warp);
    embedding.embed();
    embedding.deform();
    AdaptLimits refining = scene.refining, decimating = scene.decimating;
    refining.partitioning = decimating.partitioning = partitioning;
    Outcome outcome;
    const Refinement refinement =
        refine(active, embedding, Criteria(refining, zone, zone, &embedding));
    outcome.refined = triangles(mesh);
    const Decimation decimation = decimate(active, Criteria(decimating, zone, zone, &embedding));
    outcome.decimated = triangles(mesh);
    active.finish();
    EXPECT_EQ(mesh.validate(), std::vector<std::string>{});
    std::tie(outcome.splits, outcome.concurrent_splits, outcome.floor_hit) =
        std::tuple(refinement.splits, refinement.concurrent_splits, refinement.floor_hit);
    std::tie(outcome.unsplits, outcome.concurrent_unsplits) =
        std::tuple(decimation.unsplits, decimation.concurrent_unsplits);
    return outcome;
}

void expect_same_triangles_as_serial_adaptation(std::uint64_t first_seed, int cases,
                                                bool is_certified) {
    std::uint64_t splits = 0, unsplits = 0;
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Scene scene = random_scene(random, is_certified);
        const Outcome serial = adapted(scene, {.batch = Partitioning::kNever});
        ASSERT_FALSE(serial.floor_hit);
        ASSERT_EQ(serial.concurrent_splits + serial.concurrent_unsplits, 0u);
        const auto batch = static_cast<std::size_t>(random.integer(1, 40));
        for (const std::size_t count : {std::size_t{1}, kPartitions}) {
            SCOPED_TRACE(std::to_string(count) + " partitions");
            const Outcome concurrent = adapted(scene, {.count = count, .batch = batch});
            ASSERT_EQ(concurrent.splits, serial.splits);
            ASSERT_TRUE(concurrent.refined == serial.refined);
            ASSERT_EQ(concurrent.unsplits, serial.unsplits);
            ASSERT_TRUE(concurrent.decimated == serial.decimated);
            splits += concurrent.concurrent_splits;
            unsplits += concurrent.concurrent_unsplits;
        }
    }
    EXPECT_GT(splits, 100u * static_cast<std::uint64_t>(cases));
    EXPECT_GT(unsplits, 10u * static_cast<std::uint64_t>(cases));
    std::printf("%d seeds from %llu: %llu concurrent splits, %llu concurrent unsplits\n", cases,
                static_cast<unsigned long long>(first_seed),
                static_cast<unsigned long long>(splits), static_cast<unsigned long long>(unsplits));
}

TEST(Partitions, GiveTheSameTrianglesAsSerialAdaptationOnRandomMeshes) {
    expect_same_triangles_as_serial_adaptation(91000, test::case_count(120), false);
}

TEST(Partitions, GiveTheSameTrianglesAndErrorsWithACertificate) {
    expect_same_triangles_as_serial_adaptation(92000, test::case_count(40), true);
}

}  // namespace
}  // namespace pectin

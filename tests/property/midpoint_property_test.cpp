// Tests what the midpoint trigger promises after a drag, on random meshes and drags: no edge with
// an error above the tolerance, measured by its definition, and no vertex left that may be removed.
//
// Source: J. Griessmair, W. Purgathofer. Deformation of solids with trivariate B-splines.
// Eurographics 1989.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "adapt/adapt.h"
#include "mesh/face_tree.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

double distance_to_plane(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    return area > 0.0 ? std::abs(glm::dot(normal, p - a)) / area : glm::distance(p, 0.5 * (a + b));
}

double distance_to_line(const Vec3& p, const Vec3& a, const Vec3& b) {
    if (a == b) return glm::distance(p, a);
    const Vec3 along = glm::normalize(b - a);
    return glm::length((p - a) - glm::dot(p - a, along) * along);
}

// The distances of the image of the edge's middle from the planes of its faces, added up.
double error_by_definition(const ActiveSet& active, const Warp& warp, EdgeId e) {
    const TriMesh& mesh = active.mesh();
    const VertexId b = mesh.origin(mesh.half_edge(e)), c = mesh.target(mesh.half_edge(e));
    Vec3 image = 0.5 * (active.rest_position(b) + active.rest_position(c));
    for (const Deformation& step : warp.steps) image = pectin::image(step, image);
    std::vector<Vec3> apexes;
    mesh.for_each_side(
        e, [&](HalfEdgeId h) { apexes.push_back(mesh.position(mesh.origin(TriMesh::prev(h)))); });
    const Vec3 &at_b = mesh.position(b), &at_c = mesh.position(c);
    if (apexes.size() == 1) return distance_to_line(image, at_b, at_c);
    double sum = 0.0;
    for (const Vec3& apex : apexes) sum += distance_to_plane(image, at_b, at_c, apex);
    return sum;
}

struct Totals {
    std::uint64_t splits = 0, unsplits = 0, tested = 0;
};

void expect_errors_within(double tolerance, const ActiveSet& active, const Warp& warp,
                          Totals& totals) {
    const TriMesh& mesh = active.mesh();
    double scale = 0.0;
    for (const Vec3& p : active.rest_positions()) scale = std::max(scale, glm::length(p));
    for (EdgeId e : active.edges()) {
        if (!mesh.is_live(e)) continue;
        const HalfEdgeId h = mesh.half_edge(e);
        if (!mesh.is_deformed(mesh.origin(h)) && !mesh.is_deformed(mesh.target(h))) continue;
        ++totals.tested;
        // Thin faces have normals with rounding errors.
        EXPECT_LE(error_by_definition(active, warp, e), tolerance * (1.0 + 1e-6) + 1e-9 * scale);
    }
}

void run_case(std::uint64_t seed, Totals& totals) {
    Random random(seed);
    auto [mesh, description] = test::random_mesh(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
    const double diagonal = mesh.bounding_box().diagonal();
    for (int gesture = 0; gesture < 3; ++gesture) {
        const Warp warp = test::random_warp(mesh, random);
        // The last one decimates what the others have inserted.
        const double tolerance = diagonal * random.scale(2e-3, 2e-2) * (gesture < 2 ? 1.0 : 4.0);
        const Box zone = warp.zone();
        ActiveSet active(mesh);
        active.begin(FaceTree(mesh).faces_meeting(zone, mesh), zone);
        Embedding embedding(active, warp);
        embedding.embed();
        embedding.deform();
        const Criteria criteria(
            {.curvature = MidpointDistance(tolerance), .floor = 1e-6 * diagonal}, zone, zone,
            &embedding);
        const Adaptation done = adapt(active, embedding, criteria);
        totals.splits += done.refinement.splits;
        totals.unsplits += done.decimation.unsplits;
        EXPECT_EQ(done.refinement.concurrent_splits, 0u);
        if (!done.refinement.floor_hit) expect_errors_within(tolerance, active, warp, totals);
        for (VertexId v : active.vertices()) {
            if (!exists(v) || mesh.is_base(v)) continue;
            EXPECT_FALSE(removable_star(active, criteria, v)) << "vertex " << index(v);
        }
        active.finish();
        ASSERT_EQ(mesh.validate(), std::vector<std::string>{});
    }
}

TEST(MidpointDistance, LeavesNoErrorAboveTheToleranceAndNoVertexToRemove) {
    const int cases = test::case_count(300);
    Totals totals;
    for (int i = 0; i < cases; ++i) {
        run_case(7000 + static_cast<std::uint64_t>(i), totals);
        if (HasFailure()) return;
    }
    EXPECT_GT(totals.splits, 10u * static_cast<std::uint64_t>(cases));
    EXPECT_GT(totals.unsplits, static_cast<std::uint64_t>(cases));
    std::printf("seeds 7000 to %d: %llu splits, %llu unsplits, %llu edges tested\n",
                7000 + cases - 1, static_cast<unsigned long long>(totals.splits),
                static_cast<unsigned long long>(totals.unsplits),
                static_cast<unsigned long long>(totals.tested));
}

}  // namespace
}  // namespace pectin

// Parry's long-side rule: an edge is split only if it is the "long side" of both its faces.
// Longest-edge propagation with rho = 1 keeps it with the edge that is longest at rest.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 1, on S. Parry. Free-form deformations in a constructive solid
// geometry modeling system. PhD thesis, Brigham Young University 1986.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "adapt/adapt.h"
#include "mesh/face_tree.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

// The longest other edge of the faces that undoing the split of star.m restores, over the length of
// the edge that it restores. These are the faces that were there when the edge was split.
double longest_beside(const ActiveSet& active, const Star& star) {
    const auto distance = [&](VertexId v, VertexId w) {
        return glm::distance(active.rest_position(v), active.rest_position(w));
    };
    double longest = 0.0;
    active.mesh().for_each_sheet(star, [&](const Star& sheet) {
        longest = std::max({longest, distance(sheet.a, sheet.b), distance(sheet.a, sheet.c)});
        if (sheet.on_boundary()) return;
        longest = std::max({longest, distance(sheet.d, sheet.b), distance(sheet.d, sheet.c)});
    });
    return longest / distance(star.b, star.c);
}

struct Totals {
    std::uint64_t splits = 0;
    double greatest = 0.0;  // of longest_beside()
};

// Refines the mesh, then undoes all splits in an order that is allowed, and looks at each.
void run_case(std::uint64_t seed, double propagation, Totals& totals) {
    Random random(seed);
    auto [mesh, description] = test::random_mesh(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
    const Warp warp = test::random_warp(mesh, random);
    const double diagonal = mesh.bounding_box().diagonal();
    const std::uint32_t base_faces = mesh.face_count();
    ActiveSet active(mesh);
    active.begin(FaceTree(mesh).faces_meeting(warp.zone(), mesh), warp.zone());
    Embedding embedding(active, warp);
    embedding.embed();
    embedding.deform();
    const AdaptLimits limits{.curvature = NormalDivergence({.theta_max = random.scale(5.0, 40.0)}),
                             .l_max = diagonal * random.scale(0.05, 0.5),
                             .floor = 1e-4 * diagonal,
                             .propagation = propagation,
                             .budget = base_faces + 20'000};
    const Refinement done =
        refine(active, embedding, Criteria(limits, warp.zones(), std::nullopt, &embedding));
    // Beside an edge that the floor keeps, shorter ones may be split.
    const bool counts = !done.floor_hit;
    for (std::uint64_t removed = 0; removed < done.splits;) {
        const std::uint64_t before = removed;
        const std::vector<VertexId> vertices(active.vertices().begin(), active.vertices().end());
        for (const VertexId m : vertices) {
            if (!exists(m) || !mesh.is_live(m) || mesh.is_base(m)) continue;
            const auto star = mesh.removable(m);
            if (!star) continue;
            if (counts) totals.greatest = std::max(totals.greatest, longest_beside(active, *star));
            active.unsplit(*star);
            ++removed;
        }
        ASSERT_GT(removed, before);
    }
    EXPECT_EQ(mesh.face_count(), base_faces);
    if (counts) totals.splits += done.splits;
    active.cancel();
}

Totals run_cases(double propagation) {
    Totals totals;
    const int cases = test::case_count(200);
    for (int i = 0; i < cases && !testing::Test::HasFailure(); ++i) {
        run_case(4200 + static_cast<std::uint64_t>(i), propagation, totals);
    }
    EXPECT_GT(totals.splits, static_cast<std::uint64_t>(cases));
    return totals;
}

constexpr double kRounding = 1e-6;  // of rest lengths, which are floats

TEST(Propagation, SplitsOnlyTheLongestEdgeAtRestOfBothItsFaces) {
    EXPECT_LE(run_cases(1.0).greatest, 1.0 + kRounding);
}

TEST(Propagation, SplitsEdgesThatAreShorterByItsFactorAtMost) {
    const Totals totals = run_cases(1.3);
    EXPECT_LE(totals.greatest, 1.3 * (1.0 + kRounding));
    EXPECT_GT(totals.greatest, 1.1);
}

}  // namespace
}  // namespace pectin

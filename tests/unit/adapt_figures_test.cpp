// The conditions that the paper's figures 4 and 6 show.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, point 1 with figure 4 and point 4 (c) with figure 6.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "adapt/adapt.h"
#include "command/json.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "session/settings.h"
#include "support/mesh_figures.h"
#include "support/undulation.h"

namespace pectin {
namespace {

constexpr double kHeight = 0.12;

// What refinement has made of an undulation of the plane.
struct Refined {
    std::uint64_t splits = 0;
    double error = 0.0;  // the largest height between the surface and the mesh
};

// All points move straight up, so a point of a face is above the same point at rest.
double largest_height(const TriMesh& mesh, const LatticeField& surface) {
    double largest = 0.0;
    for (const FaceId f : test::live_faces(mesh)) {
        const auto corner = [&](int k) {
            return mesh.position(mesh.origin(TriMesh::half_edge(f, k)));
        };
        const int n = 4 + static_cast<int>(32.0 * glm::distance(corner(0), corner(1)));
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; i + j <= n; ++j) {
                const double u = 1.0 * i / n, v = 1.0 * j / n;
                const Vec3 p = (1.0 - u - v) * corner(0) + u * corner(1) + v * corner(2);
                const double height = surface.displacement({p.x, 0.0, p.z}).y;
                largest = std::max(largest, std::abs(height - p.y));
            }
        }
    }
    return largest;
}

Refined refine_undulation(int waves, const AdaptSettings& settings) {
    TriMesh mesh = build_mesh(make_shape(ShapeKind::plane, 2)).mesh;
    const Warp warp = test::undulation(waves, kHeight);
    ActiveSet active(mesh);
    active.begin(FaceTree(mesh).faces_meeting(warp.zone(), mesh), warp.zone());
    Embedding embedding(active, warp);
    embedding.embed();
    embedding.deform();
    const AdaptLimits limits =
        settings.drag_limits(warp.smallest_feature_extent(), mesh.bounding_box().diagonal());
    const Criteria criteria(limits, warp.zones(), warp.zones(), &embedding);
    Refined result{.splits = refine(active, embedding, criteria).splits};
    result.error = largest_height(mesh, std::get<LatticeField>(warp.steps.front()));
    active.finish();
    return result;
}

TEST(Undulation, IsMissedByTheNormalsAtTheEndsOfAnEdgeAndFoundWithLMax) {
    AdaptSettings settings;
    settings.l_max = Setting::off();
    const Refined without = refine_undulation(1, settings);
    EXPECT_EQ(without.splits, 0u);
    EXPECT_GT(without.error, kHeight);  // from crests to troughs
    settings.l_max = Setting::automatic();
    const Refined with = refine_undulation(1, settings);
    EXPECT_GT(with.splits, 0u);
    EXPECT_LT(with.error, 0.1 * without.error);
}

TEST(Undulation, IsMissedByTheMiddleOfAnEdgeOnACrestAndFoundWithLMax) {
    AdaptSettings settings;
    settings.trigger = command::Adapt::Trigger::midpoint;
    settings.l_max = Setting::off();
    EXPECT_GT(refine_undulation(1, settings).splits, 0u);  // the middle lies in a trough
    const Refined without = refine_undulation(2, settings);
    EXPECT_EQ(without.splits, 0u);
    EXPECT_GT(without.error, kHeight);
    settings.l_max = Setting::automatic();
    EXPECT_LT(refine_undulation(2, settings).error, 0.1 * without.error);
}

TEST(Undulation, IsFoundByTheCertificateWithoutLMax) {
    const auto certified = parse_command(R"({"cmd": "adapt", "trigger": "certified"})");
    if (!std::holds_alternative<Command>(certified)) GTEST_SKIP() << "no such trigger";
    const auto& change = std::get<command::Adapt>(std::get<Command>(certified));
    AdaptSettings settings = *AdaptSettings{}.with(change);
    settings.l_max = Setting::off();
    const double diagonal = std::sqrt(8.0);
    for (const int waves : {1, 2}) {
        for (const double tolerance : {0.02 * diagonal, 0.001 * diagonal}) {
            settings.tolerance = Setting::of(tolerance);
            const Refined refined = refine_undulation(waves, settings);
            EXPECT_GT(refined.splits, 0u);
            EXPECT_LE(refined.error, tolerance) << waves << " waves";
        }
    }
}

//     c-------d        c-------d        c-------d       p was inserted before q. Both have four
//     |\      |        |\     /|        |\     /|       edges. If p went first, bc would be
//     | \     |        | \   / |        | \   / |       restored and q would be left with three
//     |  \    |        |  \ /  |        |  \ /  |       edges, to a, b and c: it could never be
//     |   \   |  --->  |   p   |  --->  |   p   |       removed. After q, p can be removed.
//     |    \  |        |  / \  |        |  q \  |
//     |     \ |        | /   \ |        | /   \ |       (q is connected to b and c as well.)
//     a-------b        a-------b        a-------b
TEST(Decimation, RemovesTheLaterOfTwoVerticesFirstAndThenTheEarlierOne) {
    const TriMesh base = build_mesh(make_shape(ShapeKind::plane, 1)).mesh;
    TriMesh mesh = base;
    EdgeId diagonal{0};
    for (const EdgeId e : test::live_edges(mesh)) {
        if (mesh.length(e) > mesh.length(diagonal)) diagonal = e;
    }
    const Split first = mesh.split(diagonal);
    const TriMesh with_p = mesh;
    const VertexId q = mesh.split(first.am).m;
    EXPECT_FALSE(mesh.removable(first.m));
    const auto star = mesh.removable(q);
    ASSERT_TRUE(star);
    TriMesh without_q = mesh;
    without_q.unsplit(*star);
    EXPECT_TRUE(test::has_the_faces_of(without_q, with_p));
    ASSERT_TRUE(without_q.removable(first.m));

    // Decimation finds this order by itself.
    ActiveSet active(mesh);
    active.begin(test::live_faces(mesh), mesh.bounding_box());
    EXPECT_EQ(decimate(active, Criteria({}, std::nullopt, std::nullopt)).unsplits, 2u);
    active.finish();
    EXPECT_TRUE(test::has_the_faces_of(mesh, base));
}

}  // namespace
}  // namespace pectin

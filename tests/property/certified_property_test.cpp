// What the certified trigger promises, on random meshes and gestures of every kind: no face is
// farther from the exact surface than its bound, and after a gesture no bound is above the
// tolerance. The exact surface is sampled densely.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "adapt/accumulated_error.h"
#include "adapt/adapt.h"
#include "ffd/drag_plan.h"
#include "mesh/face_tree.h"
#include "session/gesture.h"
#include "support/exact_surface.h"
#include "support/mesh_figures.h"
#include "support/random_gesture.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Corners;
using test::ExactImage;
using test::Random;

// More faces than most cases need. What would need more ends here and is not tested for its bounds.
constexpr std::uint64_t kBudget = 8'000;

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[values.size() / 2];
}

// margin: faces beyond a zone, whose exact surface may reach into it, are active, too.
std::vector<FaceId> faces_in(const TriMesh& mesh, const Warp& warp, double margin = 0.0) {
    std::vector<FaceId> faces;
    const FaceTree tree(mesh);
    for (const Box& zone : warp.zones()) {
        const std::vector<FaceId> there =
            tree.faces_meeting({.min = zone.min - margin, .max = zone.max + margin}, mesh);
        faces.insert(faces.end(), there.begin(), there.end());
    }
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

AdaptLimits certified_limits(double tolerance, double diagonal, std::uint64_t budget) {
    return {.curvature = CertifiedError(tolerance), .floor = 1e-7 * diagonal, .budget = budget};
}

Corners rest_corners(const ActiveSet& active, FaceId f) {
    Corners corners;
    for (int c = 0; c < 3; ++c) {
        corners[static_cast<std::size_t>(c)] =
            active.rest_position(active.mesh().origin(TriMesh::half_edge(f, c)));
    }
    return corners;
}

struct Ratios {
    std::vector<double> one_step, several_steps;
    std::size_t faces = 0, at_budget = 0;
};

// is_complete: no limit has ended refinement.
void expect_faces_within_bounds(const ActiveSet& active, const Criteria& criteria, const Warp& warp,
                                bool is_complete, Ratios& ratios) {
    ExactImage image;
    image.add(warp);
    const CertifiedError& trigger = *criteria.certified_error();
    for (FaceId f : test::live_faces(active.mesh())) {
        const double bound = trigger.bound(active, f);
        const double error = test::sampled_error(image, rest_corners(active, f),
                                                 test::corners_of(active.mesh(), f), 5);
        ASSERT_LE(error, bound) << "face " << index(f);
        if (is_complete) {
            ASSERT_LE(bound, trigger.tolerance()) << "face " << index(f);
        }
        ++ratios.faces;
        if (!(bound > 0.1 * trigger.tolerance())) continue;
        (warp.steps.size() == 1 ? ratios.one_step : ratios.several_steps).push_back(bound / error);
    }
}

void run_gesture(std::uint64_t seed, Ratios& ratios) {
    Random random(seed);
    auto [mesh, description] = test::random_mesh(random);
    const auto [warp, gesture] = test::random_gesture(mesh, random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description + "; " + gesture);
    const double diagonal = mesh.bounding_box().diagonal();
    ActiveSet active(mesh);
    mesh.track_errors();
    active.begin(faces_in(mesh, warp), warp.zone());
    Embedding embedding(active, warp);
    embedding.embed();
    embedding.deform();
    const Criteria criteria(
        certified_limits(diagonal * random.scale(1e-2, 6e-2), diagonal, kBudget), warp.zones(),
        warp.zones(), &embedding);
    const Adaptation done = adapt(active, embedding, criteria);
    const bool is_complete = !done.refinement.budget_hit && !done.refinement.floor_hit;
    if (!is_complete) ++ratios.at_budget;
    expect_faces_within_bounds(active, criteria, warp, is_complete, ratios);
    active.finish();
}

TEST(CertifiedError, IsNeverBelowTheTrueErrorOfAFace) {
    const int cases = test::is_long() ? 2'000 : test::case_count(40);
    Ratios ratios;
    for (int i = 0; i < cases; ++i) {
        run_gesture(9000 + static_cast<std::uint64_t>(i), ratios);
        if (HasFatalFailure() || HasFailure()) return;
    }
    std::printf(
        "seeds 9000 to %d: %zu faces, %zu gestures ended by a limit; bound over error, "
        "median: %.2f of %zu faces in one step, %.2f of %zu in several\n",
        9000 + cases - 1, ratios.faces, ratios.at_budget, median(ratios.one_step),
        ratios.one_step.size(), median(ratios.several_steps), ratios.several_steps.size());
    // The few cases of a run with sanitizers have no median to speak of.
    if (test::is_sanitized()) return;
    EXPECT_LE(median(ratios.one_step), 4.0);
}

// --- Errors over many gestures

// A drag as a hand makes it: with a brush of about the usual size, by `shortest` to `longest` of
// its radius, one in five with a twist.
Warp usual_drag(const TriMesh& mesh, Random& random, double shortest, double longest) {
    const double size = mesh.bounding_box().diagonal();
    while (true) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
        if (!mesh.is_live(v)) continue;
        const double radius = size * random.scale(0.05, 0.25);
        Move move{.from = mesh.position(v)};
        move.to = move.from + radius * random.uniform(shortest, longest) * random.direction();
        if (random.chance(0.2)) {
            const Vec3 axis = random.direction();
            move.twist = Twist{axis, random.uniform(-5.0, 5.0)};
        }
        const DragPlan plan{.moves = {move},
                            .fold_free = random.chance(0.3),
                            .lattice = brush_lattice(move.from, radius, 3),
                            .is_centred_on_point = true};
        auto planned = plan_drag(plan);
        if (auto* const drag = std::get_if<PlannedDrag>(&planned)) return std::move(drag->warp);
    }
}

struct Sum {
    double accumulated = 0.0, true_error = 0.0;  // the largest of all faces
};

// Gestures one after another, by make_warp(mesh). relative_tolerance: to the diagonal. A budget
// ends refinement where drags become extreme; bounds hold all the same.
template <typename MakeWarp>
void expect_errors_to_add_up(std::uint64_t seed, int gestures, double relative_tolerance,
                             std::uint64_t budget, const MakeWarp& make_warp, Sum& sum) {
    Random random(seed);
    auto [mesh, description] = test::random_mesh(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
    const TriMesh base = mesh;
    const double diagonal = mesh.bounding_box().diagonal();
    const double tolerance = diagonal * relative_tolerance;
    ExactImage image;
    ActiveSet active(mesh);
    for (int i = 0; i < gestures; ++i) {
        const Warp warp = make_warp(mesh, random);
        image.add(warp);
        const std::span<const Vec3> last = displacements_of(warp.steps.back());
        Gesture(active, {.moving = faces_in(mesh, warp, 2.0 * largest_error(mesh))}, warp,
                Gesture::Adaptivity{certified_limits(tolerance, diagonal, budget)})
            .commit(std::vector<Vec3>(last.begin(), last.end()));
    }
    const TriMesh original = test::on_original_surface(mesh, base);
    for (FaceId f : test::live_faces(mesh)) {
        const double error =
            test::sampled_error(image, test::corners_of(original, f), test::corners_of(mesh, f), 4);
        ASSERT_LE(error, mesh.error(f).radius()) << "face " << index(f);
        sum.true_error = std::max(sum.true_error, error);
    }
    sum.accumulated = largest_error(mesh);
}

// The longest drags, as a fraction of the radius.
class AddsUpOverTwentyDrags : public testing::TestWithParam<double> {};

// With the tolerance that the program has unless it is set.
TEST_P(AddsUpOverTwentyDrags, AndIsNeverBelowTheTrueErrorAndAtMostTenTimesItInTheMedian) {
    const double longest = GetParam();
    const bool is_short = test::is_sanitized() && !test::is_long();  // too few for a median
    const int cases = is_short ? 1 : test::case_count(3);
    std::vector<double> ratios;
    for (int i = 0; i < cases; ++i) {
        Sum sum;
        const auto drag = [&](const TriMesh& mesh, Random& random) {
            return usual_drag(mesh, random, 0.02, longest);
        };
        expect_errors_to_add_up(9500 + static_cast<std::uint64_t>(i), 20, 1e-3, kBudget, drag, sum);
        if (HasFatalFailure() || HasFailure()) return;
        ratios.push_back(sum.accumulated / sum.true_error);
    }
    std::printf(
        "seeds 9500 to %d: accumulated over true error after 20 drags by up to %g of the radius: "
        "median %.2f, at most %.2f\n",
        9500 + cases - 1, longest, median(ratios), *std::ranges::max_element(ratios));
    if (!is_short) {
        EXPECT_LE(median(ratios), 10.0);
    }
}

INSTANTIATE_TEST_SUITE_P(CertifiedError, AddsUpOverTwentyDrags, testing::Values(0.1, 0.2, 0.5),
                         [](const auto& test) {
                             return "UpTo" + std::to_string(std::lround(100.0 * test.param)) +
                                    "PercentOfTheRadius";
                         });

TEST(CertifiedError, AddsUpOverGesturesOfEveryKind) {
    const auto few_steps = [](const TriMesh& mesh, Random& random) {
        while (true) {  // long warps take long and show nothing else
            const Warp warp = test::random_gesture(mesh, random).warp;
            if (warp.steps.size() <= 4) return warp;
        }
    };
    const int cases = test::case_count(12);
    for (int i = 0; i < cases; ++i) {
        Sum sum;
        const double tolerance = Random(static_cast<std::uint64_t>(i)).scale(5e-3, 3e-2);
        expect_errors_to_add_up(9700 + static_cast<std::uint64_t>(i), 3, tolerance, 2'000,
                                few_steps, sum);
        if (HasFatalFailure() || HasFailure()) return;
    }
    std::printf("seeds 9700 to %d\n", 9700 + cases - 1);
}

}  // namespace
}  // namespace pectin

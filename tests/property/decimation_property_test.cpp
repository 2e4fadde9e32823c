// Tests decimation vertex by vertex: it removes no vertex that the rules keep, and sculpted detail
// is preserved.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "adapt/adapt.h"
#include "ffd/drag_solver.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "session/gesture.h"
#include "session/settings.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

// Normals are floats, so angles are exact to about 1e-7 radians.
constexpr double kAngleSlack = 1e-4;  // degrees
constexpr double kLengthSlack = 1e-9;

double angle_deg(const Vec3f& m, const Vec3f& n) {
    const Vec3 a{m}, b{n};
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / std::numbers::pi;
}

double distance_to_plane(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double area = glm::length(glm::cross(b - a, c - a));
    // This is six times the volume of the tetrahedron, divided by twice the area of its base.
    return area > 0.0 ? std::abs(glm::determinant(Mat3{a - p, b - p, c - p})) / area
                      : glm::distance(p, 0.5 * (b + c));
}

double distance_to_line(const Vec3& p, const Vec3& b, const Vec3& c) {
    if (b == c) return glm::distance(p, b);
    const Vec3 along = glm::normalize(c - b);
    return glm::distance(p, b + glm::dot(p - b, along) * along);
}

// The decimation of one gesture, and the mesh before it.
struct DecimationRun {
    AdaptLimits limits;
    Box zone;
    TriMesh refined;
    std::vector<Vec3> rest_positions;  // by vertex id
    std::vector<Vec3f> rest_normals;   // by wedge id
    std::vector<TopologyEdit> unsplits;
    TriMesh decimated;

    const NormalDivergence& trigger() const { return std::get<NormalDivergence>(limits.curvature); }
    const NormalDivergence::Angles& angles() const { return trigger().angles(); }
    const NormalDivergence::RestAllowance& allowance() const { return trigger().allowance(); }
};

DecimationRun deform_and_decimate(TriMesh& mesh, const Warp& warp, const AdaptLimits& limits) {
    DecimationRun result{limits, warp.zone(), {}, {}, {}, {}, {}};
    ActiveSet active(mesh);
    active.begin(FaceTree(mesh).faces_meeting(result.zone, mesh), result.zone);
    Embedding embedding(active, warp);
    embedding.embed();
    embedding.deform();
    const Criteria criteria(limits, result.zone, result.zone);
    refine(active, embedding, criteria);
    result.refined = mesh;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        result.rest_positions.push_back(active.rest_position(VertexId{v}));
    }
    for (std::uint32_t w = 0; w < mesh.wedge_slots(); ++w) {
        result.rest_normals.push_back(active.rest_normal(WedgeId{w}));
    }
    const auto refining = static_cast<std::ptrdiff_t>(active.splits());
    decimate(active, criteria);
    const MeshChange change = active.finish();
    result.unsplits.assign(change.edits.begin() + refining, change.edits.end());
    result.decimated = mesh;
    return result;
}

// The largest angle between the end normals over the sides that count. allowance: sides whose
// normals differ by up to this factor more than at rest do not.
double bend_deg(const DecimationRun& t, const TriMesh& mesh, EdgeId e, double allowance) {
    const std::vector<Vec3f>& rest_normals = t.rest_normals;
    double greatest = 0.0;
    const HalfEdgeId h = mesh.half_edge(e);
    for (HalfEdgeId side : {h, mesh.twin(h)}) {
        if (!exists(side)) continue;
        const WedgeId p = mesh.wedge(side), q = mesh.wedge(TriMesh::next(side));
        const Vec3f zero{0.0f};
        if (mesh.normal(p) == zero || mesh.normal(q) == zero) continue;
        if (glm::dot(rest_normals[index(p)], rest_normals[index(q)]) < -0.5f) continue;
        const float at_rest = glm::distance(rest_normals[index(p)], rest_normals[index(q)]);
        const float now = glm::distance(mesh.normal(p), mesh.normal(q));
        if (static_cast<double>(now) <= allowance * static_cast<double>(at_rest) + 1e-6) continue;
        greatest = std::max(greatest, angle_deg(mesh.normal(p), mesh.normal(q)));
    }
    return greatest;
}

bool meets_zone_at_rest(const DecimationRun& t, const TriMesh& mesh, FaceId f) {
    Vec3 p[3];
    for (int c = 0; c < 3; ++c) {
        p[c] = t.rest_positions[index(mesh.origin(TriMesh::half_edge(f, c)))];
    }
    return triangle_meets_box(p[0], p[1], p[2], t.zone);
}

void expect_edges_of_star_pass(const DecimationRun& t, const TriMesh& mesh, VertexId m) {
    for (EdgeId e : test::live_edges(mesh)) {
        const HalfEdgeId h = mesh.half_edge(e);
        if (mesh.origin(h) != m && mesh.target(h) != m) continue;
        if (t.angles().theta_min < kOff) {
            EXPECT_LT(bend_deg(t, mesh, e, t.allowance().decimation),
                      t.angles().theta_min + kAngleSlack);
        }
        EXPECT_LT(mesh.length(e), t.limits.l_max * (1 + kLengthSlack));
    }
}

void expect_near_restored_faces(const DecimationRun& t, const TriMesh& mesh, EdgeId bc,
                                const Vec3& m) {
    if (t.limits.flatness == kOff) return;
    const HalfEdgeId h = mesh.half_edge(bc), twin = mesh.twin(h);
    const Vec3 &b = mesh.position(mesh.origin(h)), &c = mesh.position(mesh.target(h));
    const Vec3& a = mesh.position(mesh.origin(TriMesh::prev(h)));
    const double length = glm::distance(b, c);
    double distance = 0.0;
    if (exists(twin)) {
        const Vec3& d = mesh.position(mesh.origin(TriMesh::prev(twin)));
        distance = distance_to_plane(m, a, b, c) + distance_to_plane(m, d, c, b);
    } else {
        distance = distance_to_line(m, b, c);
    }
    EXPECT_LE(distance, t.limits.flatness * length + 1e-9 * (length + glm::length(m - b)));
}

void expect_restored_edge_satisfies_criteria(const DecimationRun& t, const TriMesh& mesh,
                                             EdgeId bc) {
    const HalfEdgeId h = mesh.half_edge(bc), twin = mesh.twin(h);
    if (mesh.is_deformed(mesh.origin(h)) || mesh.is_deformed(mesh.target(h))) {
        EXPECT_LE(bend_deg(t, mesh, bc, t.allowance().refinement),
                  t.angles().theta_max + kAngleSlack);
    }
    for (HalfEdgeId side : {h, twin}) {
        if (!exists(side) || !meets_zone_at_rest(t, mesh, TriMesh::face(side))) continue;
        for (HalfEdgeId of_face : {side, TriMesh::next(side), TriMesh::prev(side)}) {
            EXPECT_LE(mesh.length(mesh.edge(of_face)), t.limits.l_max * (1 + kLengthSlack));
        }
    }
}

// Repeats the unsplits one by one and checks each of them.
void replay(const DecimationRun& t) {
    TriMesh mesh = t.refined;
    int level = std::numeric_limits<int>::max();
    for (const TopologyEdit& edit : t.unsplits) {
        ASSERT_FALSE(edit.is_split());
        const VertexId m = inserted_vertex(mesh, edit.edge());
        const auto star = mesh.removable(m);
        ASSERT_TRUE(star.has_value());
        EXPECT_LE(int{mesh.level(m)}, level);
        level = mesh.level(m);
        expect_edges_of_star_pass(t, mesh, m);
        const Vec3 removed = mesh.position(m);
        ASSERT_EQ(mesh.unsplit(*star), edit.edge());
        expect_near_restored_faces(t, mesh, edit.edge(), removed);
        expect_restored_edge_satisfies_criteria(t, mesh, edit.edge());
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_TRUE(mesh == t.decimated) << "decimation moved a vertex";
}

AdaptLimits random_limits(double smallest_cell, double diagonal, Random& random) {
    AdaptSettings settings;
    settings.theta_max = Setting::of(random.scale(3.0, 60.0));
    if (random.chance(0.1)) settings.theta_max = Setting::off();
    if (random.chance(0.3)) settings.l_max = Setting::off();
    if (random.chance(0.3)) settings.flatness = Setting::of(random.scale(1e-3, 0.5));
    if (random.chance(0.1)) settings.flatness = Setting::off();
    settings.floor = Setting::of(diagonal * random.scale(1e-2, 5e-2));
    return random.chance(0.6) ? settings.drag_limits(smallest_cell, diagonal)
                              : settings.limits(smallest_cell, diagonal);
}

TEST(Decimation, RemovesOnlyFlatVerticesHighestLevelsFirst) {
    const int cases = test::case_count(400);
    std::size_t removed = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 20000 + static_cast<std::uint64_t>(i);
        Random random(seed);
        auto [mesh, description] = test::random_mesh(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        const double diagonal = mesh.bounding_box().diagonal();
        for (int gesture = 0; gesture < 3; ++gesture) {
            const Warp warp = test::random_warp(mesh, random);
            const DecimationRun t = deform_and_decimate(
                mesh, warp, random_limits(warp.smallest_feature_extent(), diagonal, random));
            removed += t.unsplits.size();
            replay(t);
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(removed, 10u * static_cast<std::size_t>(cases));
    std::printf("seeds 20000 to %d, %zu vertices removed\n", 20000 + cases - 1, removed);
}

// --- A tiny drag with a brush four times as large over sculpted detail

Warp brush_warp(const Vec3& from, double radius, const Vec3& by) {
    const std::vector<Vec3> points{from};
    auto solver =
        std::get<DragSolver>(DragSolver::create(brush_lattice(from, radius, 3), points, {}));
    return Warp{{DragStep{solver.field(), {by}}}};
}

struct Bump {
    ShapeKind shape;
    int resolution;
    Vec3 at, up;
    double radius, height;
};

// The height of the mesh above the shape it was sculpted from.
double rise(const TriMesh& mesh, const Bump& bump) {
    double highest = 0.0;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (!mesh.is_live(VertexId{v})) continue;
        const Vec3& p = mesh.position(VertexId{v});
        highest = std::max(highest, bump.shape == ShapeKind::sphere ? glm::length(p) - 1.0 : p.y);
    }
    return highest;
}

// The distance from a point to the surface along the direction `up`, upwards or downwards.
double gap(const TriMesh& mesh, const Vec3& p, const Vec3& up) {
    double nearest = std::numeric_limits<double>::infinity();
    for (FaceId f : test::live_faces(mesh)) {
        const Vec3& a = mesh.position(mesh.origin(TriMesh::half_edge(f, 0)));
        const Vec3& b = mesh.position(mesh.origin(TriMesh::half_edge(f, 1)));
        const Vec3& c = mesh.position(mesh.origin(TriMesh::half_edge(f, 2)));
        const Mat3 m{b - a, c - a, -up};
        const double volume = glm::determinant(m);
        if (std::abs(volume) < 1e-30) continue;
        const double u = glm::determinant(Mat3{p - a, c - a, -up}) / volume;
        const double v = glm::determinant(Mat3{b - a, p - a, -up}) / volume;
        if (u < -1e-9 || v < -1e-9 || u + v > 1 + 1e-9) continue;
        nearest = std::min(nearest, std::abs(glm::determinant(Mat3{b - a, c - a, p - a}) / volume));
    }
    return nearest;
}

struct Outcome {
    double kept_height;   // fraction of the height before
    double greatest_gap;  // in heights
    std::size_t unsplits;
};

// l_max and flatness are those of the tiny drag.
Outcome decimate_with_large_brush(const Bump& bump, double theta_max, const Setting& l_max,
                                  const Setting& flatness) {
    TriMesh mesh = build_mesh(make_shape(bump.shape, bump.resolution)).mesh;
    const double diagonal = mesh.bounding_box().diagonal();
    AdaptSettings settings;
    settings.theta_max = Setting::of(theta_max);
    const auto limits = [&](const Warp& warp) {
        return settings.drag_limits(warp.smallest_feature_extent(), diagonal);
    };
    const Warp sculpt = brush_warp(bump.at, bump.radius, bump.height * bump.up);
    deform_and_decimate(mesh, sculpt, limits(sculpt));
    const TriMesh sculpted = mesh;
    const double height = rise(mesh, bump);

    settings.l_max = l_max;
    settings.flatness = flatness;
    const Warp tiny = brush_warp(bump.at + 0.5 * bump.radius * Vec3{0.6, 0.0, 0.8},
                                 4.0 * bump.radius, Vec3{1e-9, 0, 0});
    const DecimationRun t = deform_and_decimate(mesh, tiny, limits(tiny));
    Outcome outcome{rise(mesh, bump) / height, 0.0, t.unsplits.size()};
    for (std::uint32_t v = 0; v < sculpted.vertex_slots(); ++v) {
        const Vec3& p = sculpted.position(VertexId{v});
        if (!sculpted.is_live(VertexId{v}) || glm::distance(p, bump.at) > bump.radius) continue;
        outcome.greatest_gap = std::max(outcome.greatest_gap, gap(mesh, p, bump.up) / height);
    }
    return outcome;
}

class SculptedBump : public testing::TestWithParam<double> {};  // theta_max, degrees

TEST_P(SculptedBump, SurvivesATinyDragWithAFourTimesLargerBrush) {
    const Bump bumps[] = {
        {ShapeKind::plane, 4, {0.13, 0, 0.21}, {0, 1, 0}, 0.3, 0.08},
        {ShapeKind::plane, 2, {-0.2, 0, 0.27}, {0, 1, 0}, 0.25, 0.1},
        {ShapeKind::plane, 40, {0.13, 0, 0.21}, {0, 1, 0}, 0.3, 0.08},
        {ShapeKind::sphere, 3, {0, 1, 0}, {0, 1, 0}, 0.4, 0.15},
        {ShapeKind::sphere, 5, {0, 1, 0}, {0, 1, 0}, 0.2, 0.06},
    };
    for (const Bump& bump : bumps) {
        SCOPED_TRACE("shape " + std::to_string(static_cast<int>(bump.shape)) + " resolution " +
                     std::to_string(bump.resolution));
        const Outcome kept =
            decimate_with_large_brush(bump, GetParam(), Setting::automatic(), Setting::automatic());
        EXPECT_GE(kept.kept_height, 0.91);
        EXPECT_LE(kept.greatest_gap, 0.09);
    }
}

INSTANTIATE_TEST_SUITE_P(AtAngles, SculptedBump, testing::Values(5.0, 10.0, 180.0 / 7.0));

TEST(FlatnessGuard, KeepsAGentleBumpWhoseEdgesAreShorterThanLMax) {
    const auto automatic = Setting::automatic(), off = Setting::off();
    for (const Vec3& at : {Vec3{0.13, 0, 0.21}, Vec3{0.25, 0, 0.25}}) {
        const Bump bump{ShapeKind::plane, 1, at, {0, 1, 0}, 0.3, 0.01};
        EXPECT_GE(decimate_with_large_brush(bump, 10.0, off, automatic).kept_height, 0.91);
        EXPECT_LT(decimate_with_large_brush(bump, 10.0, off, off).kept_height, 0.1);
    }
}

}  // namespace
}  // namespace pectin

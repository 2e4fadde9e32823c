// Tests drags in which edges longer than L_max are refined and the border of the zone crosses
// faces. After symmetric drags every face has a mirror image. Without symmetry, the refined mesh
// does not depend on the order of faces and their corners.
//
// Source of the condition: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form
// Deformation. Eurographics UK 1999, section 4 (b).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "adapt/decimate.h"
#include "adapt/refine.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "session/session.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"
#include "support/triggers.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Cage;
using command::Control;
using command::Drag;
using command::Shape;
using test::Random;

const std::vector<std::string> kValid;

// The corners of a face, rounded to multiples of a length that is far smaller than their distances,
// and sorted.
using Corner = std::array<std::int64_t, 3>;
using Corners = std::array<Corner, 3>;

Corners corners_of(const TriMesh& mesh, FaceId f, double length, double sign) {
    Corners corners;
    for (int c = 0; c < 3; ++c) {
        const Vec3& p = mesh.position(mesh.origin(TriMesh::half_edge(f, c)));
        corners[static_cast<std::size_t>(c)] = {std::llround(sign * p.x / length),
                                                std::llround(p.y / length),
                                                std::llround(p.z / length)};
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

// The number of faces without a mirror image about x = 0. Rounding to a grid may separate a corner
// from its image, so a face is counted only if it has no image on any of three grids.
std::size_t faces_without_image(const TriMesh& mesh) {
    const double size = mesh.bounding_box().diagonal();
    const std::vector<FaceId> faces = test::live_faces(mesh);
    std::vector<bool> has_image(faces.size(), false);
    for (const double length : {1e-7 * size, 1.3e-7 * size, 1.7e-7 * size}) {
        std::set<Corners> images;
        for (FaceId f : faces) images.insert(corners_of(mesh, f, length, -1.0));
        for (std::size_t i = 0; i < faces.size(); ++i) {
            if (images.contains(corners_of(mesh, faces[i], length, 1.0))) has_image[i] = true;
        }
    }
    return static_cast<std::size_t>(std::count(has_image.begin(), has_image.end(), false));
}

Drag random_drag(const TriMesh& mesh, Random& random) {
    VertexId v{0};
    do {
        v = VertexId{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
    } while (!mesh.is_live(v));
    const Vec3 from = mesh.position(v);
    Vec3 to = from + random.uniform(0.05, 0.3) * random.direction();
    if (std::abs(from.x) < 1e-6 || to.x * from.x < 0.0) to.x = from.x;
    return {.moves = {{from, to}}, .fold_free = random.chance(0.5)};
}

Control random_control(const Lattice& cage, Random& random) {
    const IVec3 last = cage.counts() - 1;
    const IVec3 index{random.integer(0, last.x), random.integer(0, last.y),
                      random.integer(0, last.z)};
    Vec3 to = cage.rest(cage.control_of_user_index(index)) + 0.3 * random.direction();
    if (2 * index.x == last.x) to.x = 0.0;
    return {{{index, to}}};
}

using Trigger = Adapt::Trigger;

// Drags by which the triggers find much to refine.
Adapt settings(Trigger trigger, Random& random) {
    Adapt adapt{.trigger = trigger, .l_max = Setting::of(random.scale(0.05, 0.12))};
    if (trigger != Trigger::normals) {
        adapt.tolerance = Setting::of(random.scale(3e-4, 1e-2));
        if (random.chance(0.5)) adapt.l_max = Setting::automatic();
    }
    return adapt;
}

void expect_symmetric_sessions(Trigger trigger, std::uint64_t first_seed, bool has_cage) {
    // A certificate takes longer.
    const int certified_cases = test::is_sanitized() ? 1 : 4;
    const int cases = test::case_count(trigger == Trigger::certified ? certified_cases : 12);
    std::size_t faces = 0;
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        Session session;
        ASSERT_TRUE(session.execute(Shape{Shape::Kind::sphere, 3}));
        ASSERT_TRUE(session.execute(command::Symmetry{.plane = command::Symmetry::Plane::x}));
        ASSERT_TRUE(session.execute(settings(trigger, random)));
        if (has_cage) {
            const IVec3 counts{random.integer(2, 4), random.integer(2, 4), random.integer(2, 4)};
            const Box box{.min = {-0.8, -0.3, -0.7}, .max = {0.8, 0.9, 0.4}};
            const Lattice lattice = fit_lattice(box, counts);
            ASSERT_TRUE(session.execute(Cage{.origin = lattice.rest({0, 0, 0}),
                                             .cell = lattice.cell,
                                             .deformable = lattice.deformable}));
        } else {
            const Falloff falloff = i % 2 == 0 ? Falloff::sharp : Falloff::plateau;
            ASSERT_TRUE(
                session.execute(Brush{.radius = random.uniform(0.4, 1.0), .falloff = falloff}));
        }
        for (int k = 0; k < 4; ++k) {
            if (has_cage && random.chance(0.5)) {
                std::ignore =
                    session.execute(random_control(*session.lattice_settings().cage, random));
            } else {
                std::ignore = session.execute(random_drag(session.mesh(), random));
            }
            ASSERT_EQ(faces_without_image(session.mesh()), 0u) << "after drag " << k;
        }
        EXPECT_EQ(session.mesh().validate(), kValid);
        faces += session.mesh().face_count();
    }
    std::printf("seeds %d to %d, %zu faces\n", static_cast<int>(first_seed),
                static_cast<int>(first_seed) + cases - 1, faces);
}

class SymmetryWithLMax : public testing::TestWithParam<Trigger> {};

TEST_P(SymmetryWithLMax, GivesEveryFaceItsImageAfterDragsOfABrush) {
    expect_symmetric_sessions(GetParam(), 6100, false);
}

TEST_P(SymmetryWithLMax, GivesEveryFaceItsImageAfterDragsAndControlPointsOfACage) {
    expect_symmetric_sessions(GetParam(), 6200, true);
}

INSTANTIATE_TEST_SUITE_P(By, SymmetryWithLMax,
                         testing::Values(Trigger::normals, Trigger::midpoint, Trigger::certified),
                         test::name_of_trigger);

// --- Without symmetry: the same mesh with its faces and corners in another order

IndexedFaceSet shuffled(const IndexedFaceSet& input, Random& random) {
    std::vector<std::uint32_t> order(input.polygon_count());
    for (std::uint32_t p = 0; p < order.size(); ++p) order[p] = p;
    for (std::size_t p = order.size(); p-- > 1;) {
        std::swap(order[p],
                  order[static_cast<std::size_t>(random.integer(0, static_cast<int>(p)))]);
    }
    IndexedFaceSet mesh = input;
    mesh.corners.clear();
    mesh.polygon_end.clear();
    for (const std::uint32_t p : order) {
        const std::uint32_t first = input.polygon_begin(p), count = input.polygon_end[p] - first;
        const auto shift = static_cast<std::uint32_t>(random.integer(0, 2));
        for (std::uint32_t c = 0; c < count; ++c) {
            mesh.corners.push_back(input.corners[first + (c + shift) % count]);
        }
        mesh.polygon_end.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    return mesh;
}

using Triangle = std::array<std::array<double, 3>, 3>;

std::vector<Triangle> triangles(const TriMesh& mesh) {
    std::vector<Triangle> all;
    for (FaceId f : test::live_faces(mesh)) {
        Triangle triangle;
        for (int c = 0; c < 3; ++c) {
            const Vec3& p = mesh.position(mesh.origin(TriMesh::half_edge(f, c)));
            triangle[static_cast<std::size_t>(c)] = {p.x, p.y, p.z};
        }
        std::sort(triangle.begin(), triangle.end());
        all.push_back(triangle);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// then_decimates: decimation follows, by these limits as well.
std::vector<Triangle> refined(const IndexedFaceSet& input, const std::vector<Vec3>& points,
                              const AdaptLimits& limits, bool then_decimates = false) {
    TriMesh mesh = build_mesh(input).mesh;
    Warp warp;
    for (const Vec3& point : points) {  // each step of the warp is a displaced lattice
        const Lattice lattice = brush_lattice(point, 0.5, 3);
        std::vector<Vec3> displacements(lattice.control_count(), Vec3{0.1, 0.02, 0.05});
        warp.steps.emplace_back(LatticeField{lattice, std::move(displacements)});
    }
    ActiveSet active(mesh);
    std::set<FaceId> faces;
    const FaceTree tree(mesh);
    for (const Box& zone : warp.zones()) {
        const std::vector<FaceId> there = tree.faces_meeting(zone, mesh);
        faces.insert(there.begin(), there.end());
    }
    active.begin(std::vector<FaceId>(faces.begin(), faces.end()), warp.zone());
    Embedding embedding(active, warp);
    embedding.embed();
    embedding.deform();
    const Criteria criteria(limits, warp.zones(), warp.zones(), &embedding);
    EXPECT_GT(refine(active, embedding, criteria).splits, 0u);
    if (then_decimates) decimate(active, criteria);
    for (EdgeId e : test::live_edges(mesh)) EXPECT_FALSE(criteria.needs_refinement(active, e));
    active.finish();
    return triangles(mesh);
}

// The displacements make the lengths of all edges different.
IndexedFaceSet irregular_sphere(Random& random) {
    IndexedFaceSet input = make_shape(ShapeKind::sphere, 2);
    for (Vec3& p : input.positions) p += random.uniform(0.0, 0.05) * random.direction();
    input.normals.clear();
    for (auto& corner : input.corners) corner.normal = IndexedFaceSet::kNoIndex;
    return input;
}

TEST(RefinementByLMax, GivesTheSameFacesForAnyOrderOfSplits) {
    const int cases = test::case_count(30);
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = 6300 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const IndexedFaceSet input = irregular_sphere(random);
        std::vector<Vec3> points;
        for (int k = random.integer(1, 3); k > 0; --k) points.push_back(random.direction());
        AdaptLimits limits{.l_max = random.scale(0.05, 0.2), .floor = 1e-4};
        if (random.chance(0.5)) limits.curvature = NormalDivergence({.theta_max = 12.0});
        limits.partitioning.batch = random.chance(0.5) ? 4 : kPartitionBatch;
        const std::vector<Triangle> expected = refined(input, points, limits);
        for (int k = 0; k < 3; ++k) {
            const std::vector<Triangle> found = refined(shuffled(input, random), points, limits);
            ASSERT_EQ(found.size(), expected.size());
            ASSERT_TRUE(found == expected);
        }
    }
    std::printf("seeds 6300 to %d\n", 6300 + cases - 1);
}

// The displacements are equal at all control points, so edges bend at the border of the zone, and
// what propagation has split elsewhere is decimated again.
TEST(MidpointDistance, GivesTheSameFacesForAnyOrderOfSplitsAndRemovals) {
    const int cases = test::case_count(30);
    std::size_t faces = 0;
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = 6400 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const IndexedFaceSet input = irregular_sphere(random);
        std::vector<Vec3> points;
        for (int k = random.integer(1, 3); k > 0; --k) points.push_back(random.direction());
        const AdaptLimits limits{.curvature = MidpointDistance(random.scale(1e-4, 3e-3)),
                                 .l_max = random.chance(0.5) ? kOff : random.scale(0.05, 0.2),
                                 .floor = 1e-4};
        const std::vector<Triangle> expected = refined(input, points, limits, true);
        faces += expected.size();
        for (int k = 0; k < 3; ++k) {
            const std::vector<Triangle> found =
                refined(shuffled(input, random), points, limits, true);
            ASSERT_EQ(found.size(), expected.size());
            ASSERT_TRUE(found == expected);
        }
    }
    std::printf("seeds 6400 to %d, %zu faces\n", 6400 + cases - 1, faces);
}

}  // namespace
}  // namespace pectin

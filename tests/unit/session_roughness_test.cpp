// Drags of models that are rough before anything was deformed: what is refined, and what is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "mesh/shapes.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Drag;
using command::Readapt;
using command::Undo;
using test::expect_done;
using test::Random;

double chord(double degrees) { return 2.0 * std::sin(0.5 * degrees * std::numbers::pi / 180.0); }

// The largest |n1 - n2| of the end normals over the sides of an edge.
double divergence(const TriMesh& mesh, EdgeId e) {
    double largest = 0.0;
    mesh.for_each_side(e, [&](HalfEdgeId h) {
        const Vec3 n1{mesh.normal(mesh.wedge(h))}, n2{mesh.normal(mesh.wedge(TriMesh::next(h)))};
        largest = std::max(largest, glm::distance(n1, n2));
    });
    return largest;
}

// A crumpled sphere of 1,280 faces: the vertices lie up to a fifth nearer to the middle. With
// creases, normals would be those of faces.
Session crumpled(std::uint64_t seed) {
    TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 3)).mesh;
    Random random(seed);
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        mesh.set_position(VertexId{v}, random.uniform(0.8, 1.0) * mesh.position(VertexId{v}));
    }
    std::string text;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        const Vec3& p = mesh.position(VertexId{v});
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) +
                "\n";
    }
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
        text += "f";
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(FaceId{f}, corner);
            text += " " + std::to_string(index(mesh.origin(h)) + 1);
        }
        text += "\n";
    }
    const ScratchFolder folder;
    folder.write("crumpled.obj", text);
    Session session;
    expect_done(session, command::Open{.path = folder.path("crumpled.obj"), .crease_angle = 180.0});
    // Otherwise long edges would be split as well.
    expect_done(session, Adapt{.l_max = Setting::off()});
    expect_done(session, Brush{.radius = 0.9});
    return session;
}

// The vertex that is farthest along `direction`.
Vec3 extreme(const TriMesh& mesh, const Vec3& direction) {
    Vec3 farthest = mesh.position(VertexId{0});
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (!mesh.is_live(VertexId{v})) continue;
        const Vec3& p = mesh.position(VertexId{v});
        if (glm::dot(p, direction) > glm::dot(farthest, direction)) farthest = p;
    }
    return farthest;
}

Drag lift(const Session& session, double by) {
    const Vec3 top = extreme(session.mesh(), {0, 1, 0});
    return {.moves = {{top, top + Vec3{0, by, 0}}}};
}

std::size_t rough_edges(const TriMesh& mesh, double theta) {
    const std::vector<EdgeId> edges = test::live_edges(mesh);
    return static_cast<std::size_t>(
        std::ranges::count_if(edges, [&](EdgeId e) { return divergence(mesh, e) > chord(theta); }));
}

TEST(Roughness, IsNotRefinedByADragThatBendsItLittle) {
    Session session = crumpled(1);
    const double theta_max = kDefaultThetaMax;
    ASSERT_GT(rough_edges(session.mesh(), theta_max), session.mesh().edge_count() / 5);
    expect_done(session, lift(session, 0.02));
    EXPECT_EQ(session.statistics().last.splits, 0u);
    EXPECT_GT(session.statistics().last.influenced_vertices, 100u);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    EXPECT_EQ(session.statistics().held_back, 0u)
        << "roughness is not what the drag wants to split";
    // By the paper's rule, which readapt applies, it is refined.
    expect_done(session, Readapt{});
    EXPECT_GT(session.statistics().last.splits, 200u);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
}

TEST(Roughness, IsNotRefinedAtAnUntouchedModelWhateverThetaMax) {
    Session session = crumpled(2);
    const TriMesh before = session.mesh();
    expect_done(session, Adapt{.theta_max = Setting::of(2.0)});
    expect_done(session, Readapt{});
    EXPECT_TRUE(session.mesh() == before);
}

// The edges that a drag bends by a quarter, counted on the same drag without refinement.
TEST(Roughness, IsRefinedWhereADragBendsItByAQuarter) {
    for (const double by : {0.01, 0.05, 0.2, 0.6}) {
        Session coarse = crumpled(3), fine = crumpled(3);
        const TriMesh before = coarse.mesh();
        expect_done(coarse, Adapt{.enabled = false});
        expect_done(coarse, lift(coarse, by));
        expect_done(fine, Adapt{.theta_max = Setting::of(2.0)});
        expect_done(fine, lift(fine, by));
        std::uint64_t bent = 0, split = 0;
        for (const EdgeId e : test::live_edges(before)) {
            const bool is_bent =
                divergence(coarse.mesh(), e) > std::max(chord(2.0), 1.25 * divergence(before, e));
            const HalfEdgeId h = before.half_edge(e);
            const bool is_split =
                fine.mesh().target(fine.mesh().half_edge(e)) != before.target(h) ||
                fine.mesh().origin(fine.mesh().half_edge(e)) != before.origin(h);
            bent += is_bent ? 1 : 0;
            split += is_split ? 1 : 0;
            EXPECT_TRUE(is_split || !is_bent) << "edge " << index(e) << " lifted by " << by;
        }
        EXPECT_EQ(split > 0, bent > 0) << "lifted by " << by;
        EXPECT_EQ(fine.statistics().needing_refinement, 0u);
        EXPECT_TRUE(bent > 50 || by < 0.5) << bent;
        EXPECT_TRUE(bent < before.edge_count() / 20 || by > 0.02) << bent;
    }
}

// Small drags do not decimate a surface that is refined, however many there are.
TEST(Roughness, LosesLittleShapeToDragsOfNothing) {
    Session session = crumpled(5);
    expect_done(session, lift(session, 0.7));
    const std::uint32_t refined = session.mesh().face_count();
    for (int i = 0; i < 50; ++i) expect_done(session, lift(session, 1e-9));
    EXPECT_GT(session.mesh().face_count(), refined / 2);
    const std::uint32_t after_fifty = session.mesh().face_count();
    for (int i = 0; i < 50; ++i) expect_done(session, lift(session, 1e-9));
    EXPECT_EQ(session.mesh().face_count(), after_fifty) << "it does not come to an end";
}

// Readapting splits rough edges by the paper's rule, and all that this inserts lies flat. The next
// drag removes it, unless flatness is not limited or decimation is off.
TEST(Roughness, DoesNotKeepFlatVertices) {
    const auto faces_after = [](const Adapt& change) {
        Session session = crumpled(6);
        const std::uint32_t base = session.mesh().face_count();
        expect_done(session, lift(session, 1e-3));
        EXPECT_EQ(session.mesh().face_count(), base);
        expect_done(session, Readapt{});
        EXPECT_GT(session.mesh().face_count(), base + 600);
        expect_done(session, change);
        expect_done(session, lift(session, 1e-3));
        return session.mesh().face_count() - base;
    };
    EXPECT_LT(faces_after({}), 200u) << "only at the border of the zone";
    EXPECT_GT(faces_after({.theta_min = Setting::of(0.0)}), 600u);
    EXPECT_GT(faces_after({.flatness = Setting::off()}), 300u);
}

// A drag of many steps relies on the angles to find what its steps bend, but at rough edges a bend
// stays hidden.
TEST(Roughness, DoesNotHideTheStepsOfALongDrag) {
    for (std::uint64_t seed = 7; seed < 10; ++seed) {
        Session session = crumpled(seed);
        expect_done(session, Adapt{.l_max = Setting::automatic()});
        expect_done(session, Brush{.radius = 0.15});
        Drag drag = lift(session, 1.5);
        drag.fold_free = true;
        expect_done(session, drag);
        ASSERT_GT(session.statistics().last.steps, 8u);
        EXPECT_EQ(session.statistics().needing_refinement, 0u);
        EXPECT_EQ(test::crossings(session.mesh()), 0u) << "seed " << seed;
        const Vec3 top = extreme(session.mesh(), {0, 1, 0});
        EXPECT_LT(glm::distance(top, drag.moves[0].to), 1e-9);
    }
}

}  // namespace
}  // namespace pectin

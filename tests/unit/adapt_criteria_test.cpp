// Each trigger and guard of adaptive meshing by itself, on two triangles.
#include "adapt/criteria.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "embedding/embedding.h"
#include "ffd/drag_solver.h"
#include "ffd/warp.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "support/mesh_figures.h"

namespace pectin {
namespace {

using test::edge_between;
using test::mesh_of;

// Two right triangles that share the edge 1-2. In the first mesh it is a crease: each side has
// wedges of its own.
const std::string kCrease =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 3/2 2/2 4/2\n";
const std::string kSmooth = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n";

const Box kEverywhere{.min = Vec3{-9.0}, .max = Vec3{9.0}};
const Box kElsewhere{.min = Vec3{5.0}, .max = Vec3{9.0}};

Vec3f rotated(double degrees) {
    const double a = degrees * std::numbers::pi / 180.0;
    return Vec3f{Vec3{std::sin(a), 0.0, std::cos(a)}};
}

NormalDivergence angles(double theta_max, double theta_min = kOff) {
    return NormalDivergence({.theta_max = theta_max, .theta_min = theta_min});
}

// Two triangles whose normals and positions the tests set. The middle edge is the one that is
// tested.
class TwoTriangles {
  public:
    explicit TwoTriangles(const std::string& obj) : mesh(mesh_of(obj)) {
        middle = edge_between(mesh, 1, 2);
    }
    // The wedge of vertex `v` in base face `f`.
    WedgeId wedge(std::uint32_t f, std::uint32_t v) const {
        for (int c = 0; c < 3; ++c) {
            const HalfEdgeId h = TriMesh::half_edge(FaceId{f}, c);
            if (index(mesh.origin(h)) == v) return mesh.wedge(h);
        }
        return kNone<WedgeId>;
    }
    bool needs(const AdaptLimits& limits, const std::optional<Box>& zone = std::nullopt) {
        return Criteria(limits, zone, std::nullopt).needs_refinement(active, middle);
    }

    TriMesh mesh;
    EdgeId middle = kNone<EdgeId>;
    ActiveSet active{mesh};
};

TEST(NeedsRefinement, ComparesTheEndNormalsOfADeformedEdgeWithThetaMax) {
    TwoTriangles two(kSmooth);
    two.mesh.set_normal(two.wedge(0, 1), rotated(30.0));
    EXPECT_FALSE(two.needs({.curvature = angles(5.0)})) << "not deformed";
    for (const VertexId end : {VertexId{1}, VertexId{2}}) {
        two.mesh.set_deformed(end, true);
        EXPECT_TRUE(two.needs({.curvature = angles(29.999)}));
        EXPECT_FALSE(two.needs({.curvature = angles(30.001)}));
        EXPECT_FALSE(two.needs({}));
        two.mesh.set_deformed(end, false);
    }
    two.mesh.set_deformed(VertexId{0}, true);
    EXPECT_FALSE(two.needs({.curvature = angles(5.0)})) << "no end of the edge";
}

TEST(NeedsRefinement, ComparesNormalsPerSideSoThatCreasesAreNotRefined) {
    TwoTriangles two(kCrease);
    two.mesh.set_deformed(VertexId{1}, true);
    for (std::uint32_t v : {1u, 2u}) two.mesh.set_normal(two.wedge(1, v), rotated(90.0));
    EXPECT_FALSE(two.needs({.curvature = angles(5.0)})) << "flat on both sides of a right angle";
    two.mesh.set_normal(two.wedge(1, 2), rotated(120.0));
    EXPECT_TRUE(two.needs({.curvature = angles(29.99)})) << "bent on the right";
    EXPECT_FALSE(two.needs({.curvature = angles(30.01)}));
    two.mesh.set_normal(two.wedge(1, 2), rotated(90.0));
    two.mesh.set_normal(two.wedge(0, 1), rotated(-30.0));
    EXPECT_TRUE(two.needs({.curvature = angles(29.99)})) << "bent on the left";
    EXPECT_FALSE(two.needs({.curvature = angles(30.01)}));
}

TEST(NeedsRefinement, DoesNotTestASideWithoutNormalsOrWhoseNormalsStayOpposed) {
    TwoTriangles two(kCrease);
    two.mesh.set_deformed(VertexId{1}, true);
    two.mesh.set_normal(two.wedge(0, 1), Vec3f{0.0f});
    EXPECT_FALSE(two.needs({.curvature = angles(5.0)}));
    // 119 degrees at rest are a bend, 121 degrees a spike that was there before the drag. The spike
    // counts once the drag has opened it.
    for (const double rest : {119.0, 121.0}) {
        TwoTriangles spike(kCrease);
        spike.mesh.set_normal(spike.wedge(0, 1), rotated(rest));
        spike.active.begin(std::vector<FaceId>{FaceId{0}, FaceId{1}}, kEverywhere);
        spike.mesh.set_deformed(VertexId{1}, true);
        spike.mesh.set_normal(spike.wedge(0, 1), rotated(60.0));
        EXPECT_TRUE(spike.needs({.curvature = angles(20.0)}));
        // The bend counts, however far the drag turns it.
        spike.mesh.set_normal(spike.wedge(0, 1), rotated(170.0));
        EXPECT_EQ(spike.needs({.curvature = angles(20.0)}), rest < 120.0);
        spike.active.finish();
    }
}

// 40 degrees at rest are 0.684 as a chord. A quarter more is 50.6 degrees.
TEST(NeedsRefinement, AllowsAnEdgeThatWasRoughAtRestAQuarterMore) {
    const NormalDivergence allowing({.theta_max = 20.0}, {.refinement = 1.25});
    const auto needs = [&](double at_rest, double now, const NormalDivergence& trigger) {
        TwoTriangles two(kSmooth);
        two.mesh.set_normal(two.wedge(0, 1), at_rest < 0.0 ? Vec3f{0.0f} : rotated(at_rest));
        two.active.begin(std::vector<FaceId>{FaceId{0}, FaceId{1}}, kEverywhere);
        two.mesh.set_deformed(VertexId{1}, true);
        two.mesh.set_normal(two.wedge(0, 1), rotated(now));
        const bool result = two.needs({.curvature = trigger});
        two.active.finish();
        return result;
    };
    EXPECT_FALSE(needs(40.0, 40.0, allowing));
    EXPECT_FALSE(needs(40.0, 50.5, allowing));
    EXPECT_TRUE(needs(40.0, 50.7, allowing));
    EXPECT_TRUE(needs(40.0, 40.0, angles(20.0))) << "the paper's rule";
    // Where theta_max is larger, it decides.
    EXPECT_FALSE(needs(2.0, 19.9, allowing));
    EXPECT_TRUE(needs(2.0, 20.1, allowing));
    // Nothing is allowed where the normal at rest is undefined.
    EXPECT_TRUE(needs(-1.0, 20.1, allowing));
    // A quarter more than 110 degrees is more than normals can diverge.
    EXPECT_FALSE(needs(110.0, 179.0, allowing));
    EXPECT_TRUE(needs(110.0, 179.0, angles(20.0)));
}

TEST(NeedsRefinement, FindsLongEdgesOfFacesThatMeetTheZone) {
    TwoTriangles two(kSmooth);
    const double length = std::sqrt(2.0);
    EXPECT_TRUE(two.needs({.l_max = length - 1e-9}, kEverywhere));
    EXPECT_FALSE(two.needs({.l_max = length + 1e-9}, kEverywhere));
    EXPECT_FALSE(two.needs({.l_max = 0.1}, kElsewhere));
    EXPECT_FALSE(two.needs({.l_max = 0.1}, std::nullopt));
    EXPECT_FALSE(two.needs({}, kEverywhere));
    // It is enough that one of the two faces touches the zone.
    EXPECT_TRUE(two.needs({.l_max = 0.1}, Box{.min = Vec3{-1.0}, .max = Vec3{0.0}}));
    EXPECT_TRUE(two.needs({.l_max = 0.1}, Box{.min = Vec3{1, 1, 0}, .max = Vec3{2.0}}));
    // The present length counts, but the zone is compared with rest positions.
    two.active.begin(std::vector<FaceId>{FaceId{0}, FaceId{1}}, kEverywhere);
    for (std::uint32_t v = 0; v < 4; ++v) {
        two.mesh.set_position(VertexId{v}, 3.0 * two.mesh.position(VertexId{v}) + Vec3{0, 0, 7});
    }
    EXPECT_TRUE(two.needs({.l_max = 3.0 * length - 1e-9}, kEverywhere));
    EXPECT_FALSE(two.needs({.l_max = 3.0 * length + 1e-9}, kEverywhere));
    EXPECT_FALSE(two.needs({.l_max = 0.1}, Box{.min = Vec3{0, 0, 6}, .max = Vec3{9.0}}));
    EXPECT_TRUE(two.needs({.l_max = 0.1}, Box{.min = Vec3{0.0}, .max = Vec3{1.0}}));
    two.active.finish();
}

// So refinement does not depend on which edge of a face is tested first.
TEST(NeedsRefinement, SplitsACoarseFaceOnlyAtItsLongestRestEdge) {
    TwoTriangles two(kSmooth);
    const EdgeId side = edge_between(two.mesh, 0, 1);
    const Criteria criteria({.l_max = 0.9, .floor = 0.1}, kEverywhere, std::nullopt);
    EXPECT_TRUE(criteria.needs_refinement(two.active, two.middle));
    EXPECT_FALSE(criteria.needs_refinement(two.active, side)) << "though it is long itself";
    // One end moves. The middle edge is short now, but still the longest at rest.
    two.active.begin(std::vector<FaceId>{FaceId{0}, FaceId{1}}, kEverywhere);
    two.mesh.set_position(VertexId{2}, {0.5, 0.1, 0});
    ASSERT_LT(two.mesh.length(two.middle), 0.9);
    EXPECT_TRUE(criteria.needs_refinement(two.active, two.middle));
    EXPECT_FALSE(criteria.needs_refinement(two.active, side));
    // If the floor keeps the middle edge from being split, the next edge is split.
    two.mesh.set_position(VertexId{2}, {0.9, 0.0, 0});
    EXPECT_FALSE(criteria.needs_refinement(two.active, two.middle));
    EXPECT_TRUE(criteria.needs_refinement(two.active, side) ||
                criteria.needs_refinement(two.active, edge_between(two.mesh, 0, 2)));
    two.active.finish();
}

TEST(NeedsRefinement, AsksForOneOfEquallyLongEdgesWithoutSymmetry) {
    // Edges 0-1 and 0-2 are equally long and the longest of the only face.
    TriMesh mesh = mesh_of("v 0 2 0\nv -0.5 0 0\nv 0.5 0 0\nf 1 2 3\n");
    ActiveSet active(mesh);
    const Criteria criteria({.l_max = 0.4, .floor = 0.01}, kEverywhere, std::nullopt);
    int needed = 0;
    for (const EdgeId e : test::live_edges(mesh))
        needed += criteria.needs_refinement(active, e) ? 1 : 0;
    EXPECT_EQ(needed, 1);
}

TEST(Floor, ForbidsHalvesThatAreShorter) {
    TwoTriangles two(kSmooth);
    const double half = 0.5 * std::sqrt(2.0);
    const auto below = [&](double floor) {
        return Criteria({.floor = floor}, std::nullopt, std::nullopt)
            .is_below_floor(two.mesh, two.middle);
    };
    EXPECT_TRUE(below(half + 1e-9));
    EXPECT_FALSE(below(half - 1e-9));
    EXPECT_FALSE(below(0.0));
}

// Two steps act on a face inside a plane, whose edges are long. A smooth edge shows what they bend;
// a rough one hides it, if the trigger allows that.
TEST(NeedsRefinement, SamplesEachStepAtEdgesThatHideBends) {
    const auto needs = [](double at_rest, double allowance) {
        TriMesh mesh = build_mesh(make_shape(ShapeKind::plane, 6)).mesh;
        const Vec3 middle = mesh.bounding_box().centre();
        const FaceId inside = *FaceTree(mesh).nearest(middle + Vec3{0.01, 0.0, 0.02}, mesh);
        const HalfEdgeId h = TriMesh::half_edge(inside, 0);
        const double angle = at_rest * std::numbers::pi / 180.0;
        mesh.set_normal(mesh.wedge(h), Vec3f{Vec3{std::sin(angle), std::cos(angle), 0.0}});
        const auto solver = std::get<DragSolver>(
            DragSolver::create(brush_lattice(middle, 3.0, 3), {&middle, 1}, {}));
        Warp warp;
        warp.moves_middles_most = true;
        for (int step = 0; step < 2; ++step) {
            warp.steps.push_back(DragStep{solver.field(), {Vec3{0.0, 1e-3, 0.0}}});
        }
        ActiveSet active(mesh);
        active.begin(test::live_faces(mesh), warp.zone());
        Embedding embedding(active, warp);
        embedding.embed();
        embedding.deform();
        // At rest the face does not meet the zone, so L_max only holds before the later step.
        const AdaptLimits limits{
            .curvature = NormalDivergence({.theta_max = 20.0}, {.refinement = allowance}),
            .l_max = 0.5 * mesh.length(mesh.edge(h)),
            .l_max_is_automatic = true};
        const Criteria criteria(limits, std::vector{kElsewhere}, std::nullopt, &embedding);
        const bool result = exists(criteria.length().needed_split(active, h));
        active.cancel();
        return result;
    };
    // 1.25 times the difference at 36 degrees is that at 45.
    EXPECT_FALSE(needs(35.0, 1.25));
    EXPECT_TRUE(needs(37.0, 1.25));
    EXPECT_FALSE(needs(37.0, 0.0)) << "without an allowance nothing is hidden";
}

// --- Decimation: m is the midpoint of the middle edge

class Midpoint : public TwoTriangles {
  public:
    explicit Midpoint(const std::string& obj = kSmooth) : TwoTriangles(obj) {
        split = mesh.split(middle);
    }
    void lift(double height) {
        mesh.set_position(split.m, {0.5, 0.5, height});
        mesh.set_deformed(split.m, true);
    }
    bool may_unsplit(const AdaptLimits& limits, const std::optional<Box>& zone = std::nullopt,
                     const std::optional<Box>& scope = std::nullopt) {
        return Criteria(limits, zone, scope).may_unsplit(active, *mesh.removable(split.m));
    }
    Split split;
};

const double kLength = std::sqrt(2.0);  // of the restored edge

TEST(MayUnsplit, AcceptsEveryVertexWithAllLimitsOff) {
    Midpoint m;
    m.lift(5.0);
    m.mesh.set_normal(m.split.left.m, rotated(170.0));
    EXPECT_TRUE(m.may_unsplit({}));
}

TEST(MayUnsplit, RequiresAllFourEdgesToDivergeByLessThanThetaMin) {
    for (const std::uint32_t bent : {0u, 1u, 2u, 3u}) {
        Midpoint m;
        const WedgeId w = m.wedge(bent < 3 ? 0 : 1, bent);
        // The faces on both sides keep the wedges of the base corners.
        m.mesh.set_normal(exists(w) ? w : m.split.left.c, rotated(20.0));
        EXPECT_TRUE(m.may_unsplit({.curvature = angles(kOff, 20.001)})) << bent;
        EXPECT_FALSE(m.may_unsplit({.curvature = angles(kOff, 19.999)})) << bent;
    }
}

// The edge from m to vertex 0. A tenth more than 40 degrees, as chords, is 44.2 degrees.
TEST(MayUnsplit, AllowsAnEdgeThatWasRoughAtRestATenthMore) {
    const auto may_unsplit = [](double now, double allowed) {
        Midpoint m;
        m.mesh.set_normal(m.wedge(0, 0), rotated(40.0));
        m.active.begin(std::vector<FaceId>{FaceId{0}, FaceId{1}, FaceId{2}, FaceId{3}},
                       kEverywhere);
        m.mesh.set_normal(m.wedge(0, 0), rotated(now));
        const bool result = m.may_unsplit(
            {.curvature = NormalDivergence({.theta_min = 20.0}, {.decimation = allowed})});
        m.active.finish();
        return result;
    };
    EXPECT_TRUE(may_unsplit(40.0, 1.1));
    EXPECT_TRUE(may_unsplit(44.1, 1.1));
    EXPECT_FALSE(may_unsplit(44.3, 1.1));
    EXPECT_FALSE(may_unsplit(40.0, 0.0)) << "the paper's rule";
    EXPECT_TRUE(may_unsplit(19.9, 0.0));
}

TEST(MayUnsplit, TestsBothSidesOfACrease) {
    Midpoint m(kCrease);
    m.mesh.set_normal(m.split.right->m, rotated(20.0));
    EXPECT_TRUE(m.may_unsplit({.curvature = angles(kOff, 20.001)}));
    EXPECT_FALSE(m.may_unsplit({.curvature = angles(kOff, 19.999)}));
}

TEST(MayUnsplit, KeepsVerticesThatLieTooFarFromTheRestoredFaces) {
    Midpoint m;
    for (const double height : {0.05, -0.05}) {
        m.lift(height);
        // |f1.delta| + |f2.delta| is twice the height, since the restored faces are coplanar.
        EXPECT_TRUE(m.may_unsplit({.flatness = 2.0 * 0.05 / kLength + 1e-9}));
        EXPECT_FALSE(m.may_unsplit({.flatness = 2.0 * 0.05 / kLength - 1e-9}));
    }
    // The vertex may slide within the plane of the restored faces.
    m.mesh.set_position(m.split.m, {0.8, 0.1, 0.0});
    EXPECT_TRUE(m.may_unsplit({.flatness = 1e-9}));
}

TEST(MayUnsplit, CountsAllOfTheDistanceWhereARestoredFaceHasNoArea) {
    Midpoint m;
    m.lift(0.0);
    m.mesh.set_position(VertexId{0}, {0.5, 0.5, 0.0});  // on the edge
    m.mesh.set_position(m.split.m, {0.6, 0.4, 0.0});
    const double away = std::sqrt(0.02) / kLength;
    EXPECT_TRUE(m.may_unsplit({.flatness = away + 1e-9}));
    EXPECT_FALSE(m.may_unsplit({.flatness = away - 1e-9}));
}

TEST(MayUnsplit, MeasuresABoundaryVertexFromItsEdge) {
    TriMesh mesh = mesh_of("v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
    const Split s = mesh.split(edge_between(mesh, 0, 1));
    mesh.set_position(s.m, {0.7, -0.03, 0.04});
    ActiveSet active(mesh);
    const auto may_unsplit = [&](double flatness) {
        return Criteria({.flatness = flatness}, std::nullopt, std::nullopt)
            .may_unsplit(active, *mesh.removable(s.m));
    };
    EXPECT_TRUE(may_unsplit(0.05 / 2.0 + 1e-9));
    EXPECT_FALSE(may_unsplit(0.05 / 2.0 - 1e-9));
    // An edge of zero length has no line to measure from.
    mesh.set_position(VertexId{1}, Vec3{0.0});
    EXPECT_FALSE(may_unsplit(100.0));
}

TEST(MayUnsplit, KeepsVerticesWhoseMergedEdgeWouldNeedRefinement) {
    Midpoint m;
    m.mesh.set_normal(m.split.left.b, rotated(-15.0));
    m.mesh.set_normal(m.split.left.c, rotated(15.0));
    const AdaptLimits limits{.curvature = angles(29.99, 20.0)};
    EXPECT_TRUE(m.may_unsplit(limits)) << "nothing is deformed";
    m.mesh.set_deformed(VertexId{1}, true);
    EXPECT_FALSE(m.may_unsplit(limits));
    EXPECT_TRUE(m.may_unsplit({.curvature = angles(30.01, 20.0)}));
    // Both halves pass; only the merged edge does not.
    m.mesh.set_deformed(VertexId{1}, false);
    m.mesh.set_deformed(VertexId{2}, true);
    EXPECT_FALSE(m.may_unsplit(limits));
}

TEST(MayUnsplit, TestsBothSidesOfTheMergedEdge) {
    Midpoint m(kCrease);
    m.mesh.set_deformed(VertexId{1}, true);
    m.mesh.set_normal(m.split.right->b, rotated(-15.0));
    m.mesh.set_normal(m.split.right->c, rotated(15.0));
    EXPECT_FALSE(m.may_unsplit({.curvature = angles(29.99, 20.0)}));
    EXPECT_TRUE(m.may_unsplit({.curvature = angles(30.01, 20.0)}));
}

TEST(MayUnsplit, RequiresItsEdgesToBeShorterThanLMaxInAndOutOfTheZone) {
    Midpoint m;
    const double half = 0.5 * kLength;
    EXPECT_TRUE(m.may_unsplit({.l_max = half + 1e-9}));
    EXPECT_FALSE(m.may_unsplit({.l_max = half - 1e-9}));
    EXPECT_FALSE(m.may_unsplit({.l_max = half - 1e-9}, kElsewhere));
}

TEST(MayUnsplit, KeepsVerticesWhoseRestoredFacesInTheZoneWouldHaveLongEdges) {
    Midpoint m;
    EXPECT_FALSE(m.may_unsplit({.l_max = kLength - 1e-9}, kEverywhere)) << "the restored edge";
    EXPECT_TRUE(m.may_unsplit({.l_max = kLength + 1e-9}, kEverywhere));
    EXPECT_TRUE(m.may_unsplit({.l_max = kLength - 1e-9}, kElsewhere));
    // The outer edge 0-1 is long, and its face meets the zone only once it is restored: the zone is
    // in the face 0, m, 2, to which the edge 0-1 does not belong.
    Midpoint outer;
    outer.mesh.set_position(VertexId{1}, {1.5, 0, 0});
    outer.mesh.set_position(outer.split.m, {0.75, 0.5, 0});
    const Box near_2{.min = {-0.1, 0.8, -0.1}, .max = {0.05, 1.1, 0.1}};
    const double half = std::hypot(0.75, 0.5);
    EXPECT_FALSE(outer.may_unsplit({.l_max = 1.2}, near_2));
    EXPECT_GT(1.2, half);
    EXPECT_TRUE(outer.may_unsplit({.l_max = 1.2}, kElsewhere));
    EXPECT_TRUE(outer.may_unsplit({.l_max = 2.0}, near_2));
    // The same for the face on the other side.
    const Box near_3{.min = {0.95, 0.95, -0.1}, .max = {1.1, 1.1, 0.1}};
    EXPECT_FALSE(outer.may_unsplit({.l_max = 1.2}, near_3));
}

TEST(MayUnsplit, AcceptsOnlyStarsThatMeetTheScope) {
    Midpoint m;
    EXPECT_TRUE(m.may_unsplit({}, std::nullopt, kEverywhere));
    EXPECT_FALSE(m.may_unsplit({}, std::nullopt, kElsewhere));
    // Boxes around one corner or within one of the four faces.
    for (std::uint32_t v = 0; v < 4; ++v) {
        const Vec3 p = m.mesh.position(VertexId{v});
        EXPECT_TRUE(m.may_unsplit({}, std::nullopt, Box{.min = p - 0.01, .max = p + 0.01}));
    }
    for (const Vec3& p : {Vec3{0.4, 0.1, 0}, {0.1, 0.4, 0}, {0.9, 0.6, 0}, {0.6, 0.9, 0}}) {
        EXPECT_TRUE(m.may_unsplit({}, std::nullopt, Box{.min = p - 0.01, .max = p + 0.01}));
    }
}

}  // namespace
}  // namespace pectin

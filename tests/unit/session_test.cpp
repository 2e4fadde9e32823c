// The interface of a session: steps, settings, refusals and statistics.
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <tuple>

#include "io/obj_writer.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Cage;
using command::Drag;
using command::Readapt;
using command::Redo;
using command::Shape;
using command::Undo;

using test::expect_done;

// Expects that the command is refused and changes nothing, and returns the refusal.
std::string refusal_of(Session& session, const Command& command) {
    const TriMesh before = session.mesh();
    const Done done = session.execute(command);
    EXPECT_TRUE(session.mesh() == before) << name(command) << " changed the mesh";
    EXPECT_FALSE(done) << name(command) << " was done";
    return done ? "" : done.refusal().reason;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

Shape shape(Shape::Kind kind, int resolution) { return {kind, resolution}; }

Drag drag(const Vec3& from, const Vec3& by) { return {.moves = {{from, from + by}}}; }

const Vec3 kTop{0, 1, 0};

Session sphere(int resolution = 3) {
    Session session;
    expect_done(session, shape(Shape::Kind::sphere, resolution));
    return session;
}

const VertexId kNoVertex = kNone<VertexId>;

VertexId vertex_at(const TriMesh& mesh, const Vec3& p) {
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (mesh.is_live(VertexId{v}) && mesh.position(VertexId{v}) == p) return VertexId{v};
    }
    return kNoVertex;
}

// --- Steps

TEST(Session, UndoesAndRedoesAsManyStepsAsItIsAsked) {
    Session session = sphere();
    std::vector<TriMesh> states{session.mesh()};
    for (double y : {0.1, 0.2, -0.15}) {
        expect_done(session, drag(states.size() == 1 ? kTop : Vec3{1, 0, 0}, {0, y, 0}));
        states.push_back(session.mesh());
        EXPECT_FALSE(states.back() == states[states.size() - 2]);
    }
    expect_done(session, Undo{});
    EXPECT_TRUE(session.mesh() == states[2]);
    expect_done(session, Undo{.count = 2});
    EXPECT_TRUE(session.mesh() == states[0]);
    expect_done(session, Redo{.count = 3});
    EXPECT_TRUE(session.mesh() == states[3]);
    expect_done(session, Undo{.count = 3});
    expect_done(session, Redo{});
    EXPECT_TRUE(session.mesh() == states[1]);
}

TEST(Session, RefusesToUndoOrRedoMoreThanThereIs) {
    Session session;
    EXPECT_TRUE(contains(refusal_of(session, Undo{}), "0 steps"));
    session = sphere();
    EXPECT_TRUE(contains(refusal_of(session, Undo{}), "0 steps"));
    EXPECT_TRUE(contains(refusal_of(session, Redo{}), "0 steps"));
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    EXPECT_TRUE(contains(refusal_of(session, Undo{.count = 2}), "not 2"));
    EXPECT_TRUE(contains(refusal_of(session, Redo{}), "0 steps"));
    expect_done(session, Undo{});
    EXPECT_TRUE(contains(refusal_of(session, Redo{.count = 2}), "not 2"));
    expect_done(session, Redo{});
}

TEST(Session, DropsRedoByANewStepButNotBySettingsStatisticsAndFiles) {
    Session session = sphere();
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    const TriMesh dragged = session.mesh();
    expect_done(session, Undo{});
    expect_done(session, Adapt{.theta_max = Setting::of(5.0)});
    expect_done(session, Brush{.radius = 0.1});
    expect_done(session, Cage{.fit = IVec3{2, 2, 2}});
    const auto folder = std::filesystem::path(testing::TempDir()) / "pectin session";
    std::filesystem::create_directories(folder);
    expect_done(session, command::Save{(folder / "a.obj").string()});
    expect_done(session, command::Stats{(folder / "a.json").string()});
    std::filesystem::remove_all(folder);
    EXPECT_GT(session.statistics().faces, 0u);
    EXPECT_FALSE(refusal_of(session, drag({9, 9, 9}, {0, 0.1, 0})).empty());
    expect_done(session, drag(kTop, Vec3{0.0}));  // adds no step
    // Redo restores the stored result, although the present settings would give another one.
    expect_done(session, Redo{});
    EXPECT_TRUE(session.mesh() == dragged);
    expect_done(session, Undo{});
    expect_done(session, drag(kTop, {0, 0.05, 0}));
    EXPECT_FALSE(refusal_of(session, Redo{}).empty());
}

TEST(Session, TakesNoStepForADragThatMovesNothing) {
    Session session = sphere();
    const TriMesh before = session.mesh();
    expect_done(session, drag(kTop, Vec3{0.0}));
    EXPECT_TRUE(session.mesh() == before);
    EXPECT_GT(session.statistics().last.influenced_vertices, 0u);
    EXPECT_FALSE(refusal_of(session, Undo{}).empty());
}

TEST(Session, TakesAStepForADragThatOnlyChangesNormals) {
    Session session;
    expect_done(session, shape(Shape::Kind::plane, 1));
    expect_done(session, Adapt{.enabled = false});
    expect_done(session,
                Cage{.origin = Vec3{-2, -2, -2}, .cell = Vec3{1.0}, .deformable = IVec3{5, 5, 5}});
    const TriMesh before = session.mesh();
    Drag pinned = drag({0.1, 0, 0.2}, {0, 0.1, 0});
    pinned.pins = {{1, 0, 1}, {1, 0, -1}, {-1, 0, 1}, {-1, 0, -1}};
    expect_done(session, pinned);
    ASSERT_FALSE(session.mesh() == before);
    expect_done(session, Undo{});
    EXPECT_TRUE(session.mesh() == before);
}

TEST(Session, StartsANewHistoryWithANewObjectAndKeepsItsSettings) {
    Session session;
    expect_done(session, Brush{.radius = 0.3, .span = 5});
    expect_done(session, Adapt{.theta_max = Setting::of(7.0), .l_max = Setting::off()});
    expect_done(session, shape(Shape::Kind::sphere, 3));
    expect_done(session, drag(kTop, {0, 0.05, 0}));
    const TriMesh dragged = session.mesh();
    expect_done(session, shape(Shape::Kind::cube, 2));
    EXPECT_FALSE(refusal_of(session, Undo{}).empty());
    const Statistics fresh = session.statistics();
    EXPECT_EQ(fresh.last.splits, 0u);
    EXPECT_EQ(fresh.max_level, 0);
    EXPECT_FALSE(session.lattice_in_use().has_value());
    expect_done(session, shape(Shape::Kind::sphere, 3));
    expect_done(session, drag(kTop, {0, 0.05, 0}));
    EXPECT_TRUE(session.mesh() == dragged);
    EXPECT_EQ(session.lattice_in_use()->deformable, IVec3(5));
}

TEST(Session, GivesTheSameBytesForTheSameCommands) {
    const auto run = [] {
        Session session = sphere();
        expect_done(session, drag(kTop, {0.1, 0.3, 0}));
        expect_done(session, Brush{.radius = 0.4});
        expect_done(session, drag({1, 0, 0}, {0.1, 0, 0.1}));
        expect_done(session, Undo{});
        expect_done(session, drag({0, 0, 1}, {0.1, 0, 0.1}));
        expect_done(session, Readapt{});
        return session;
    };
    const Session once = run(), again = run();
    EXPECT_TRUE(once.mesh() == again.mesh());
    EXPECT_EQ(format_obj(once.mesh()), format_obj(again.mesh()));
}

TEST(Session, CanBeMovedWithAnObject) {
    Session session = sphere();
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    Session other = std::move(session);
    session = Session();
    expect_done(other, drag({1, 0, 0}, {0.1, 0, 0}));
    expect_done(other, Undo{.count = 2});
    EXPECT_EQ(session.mesh().face_count(), 0u);
}

// --- Refusals

TEST(Session, RefusesCommandsThatNeedAnObjectWithoutOne) {
    Session session;
    EXPECT_TRUE(contains(refusal_of(session, drag(kTop, {0, 1, 0})), "no object"));
    EXPECT_TRUE(contains(refusal_of(session, Readapt{}), "no object"));
    EXPECT_TRUE(contains(refusal_of(session, Cage{.fit = IVec3{2, 2, 2}}), "no object"));
    EXPECT_TRUE(contains(refusal_of(session, command::Save{"/nowhere/a.obj"}), "no object"));
    EXPECT_TRUE(contains(refusal_of(session, command::Stats{"/nowhere/a.json"}), "no object"));
    expect_done(session, Cage{.origin = Vec3{0.0},
                              .cell = Vec3{1.0},
                              .deformable = IVec3{2, 2, 2}});  // needs no object
}

TEST(Session, RefusesMovesOfTheHandWithTheWordsThatScriptsGet) {
    for (const Move& wrong : {Move{.from = kTop, .to = kTop, .scale = 2000.0},
                              Move{.from = kTop, .to = kTop, .twist = Twist{{0, 1, 0}, 4000.0}}}) {
        Session session = sphere();
        ASSERT_TRUE(session.begin_drag(std::vector{kTop}, {}));
        const Done by_hand = session.drag_to(std::span(&wrong, 1));
        ASSERT_FALSE(by_hand);
        session.cancel_drag();
        EXPECT_EQ(by_hand.refusal().reason, refusal_of(session, Drag{.moves = {wrong}}));
    }
}

TEST(Session, RefusesADragWithoutMoves) {
    Session session = sphere();
    EXPECT_TRUE(contains(refusal_of(session, Drag{}), "one or more"));
    EXPECT_TRUE(contains(refusal_of(session, Drag{.pins = {kTop}}), "one or more"));
}

TEST(Session, RefusesExtremelyLongDrags) {
    Session session = sphere();
    EXPECT_TRUE(contains(refusal_of(session, drag(kTop, {0, 1e8, 0})), "million times"));
    EXPECT_TRUE(contains(refusal_of(session, drag(kTop, {0, 1e308, 0})), "million times"));
    EXPECT_FALSE(refusal_of(session, drag(kTop, {0, NAN, 0})).empty());
    EXPECT_FALSE(refusal_of(session, drag({0, INFINITY, 0}, {0, 1, 0})).empty());
    expect_done(session,
                Cage{.origin = Vec3{-1.0}, .cell = Vec3{1.0}, .deformable = IVec3{2, 2, 2}});
    EXPECT_FALSE(refusal_of(session, drag({9, 9, 9}, {0, 1, 0})).empty());
    Drag both{.moves = {{kTop, {0, 2, 0}}, {kTop, {0, 3, 0}}}};
    EXPECT_FALSE(refusal_of(session, both).empty());
    both.moves[1].to = {0, 2, 0};
    expect_done(session, both);
}

TEST(Session, RefusesResolutionsThatShapesDoNotHave) {
    Session session = sphere(1);
    EXPECT_TRUE(contains(refusal_of(session, shape(Shape::Kind::sphere, -1)), "from 0"));
    EXPECT_TRUE(contains(refusal_of(session, shape(Shape::Kind::cube, 0)), "from 1"));
    EXPECT_FALSE(refusal_of(session, shape(Shape::Kind::sphere, 99)).empty());
    EXPECT_FALSE(refusal_of(session, shape(Shape::Kind::torus, 1 << 30)).empty());
}

TEST(Session, RefusesThetaMinThatIsNotBelowThetaMaxAlsoAcrossCommands) {
    Session session = sphere();
    expect_done(session, Adapt{.theta_min = Setting::of(20.0)});
    EXPECT_TRUE(contains(refusal_of(session, Adapt{.theta_max = Setting::of(20.0)}), "theta_min"));
    EXPECT_TRUE(contains(refusal_of(session, Adapt{.theta_max = Setting::of(15.0)}), "theta_min"));
    expect_done(session, Adapt{.theta_max = Setting::of(20.5)});
    EXPECT_FALSE(refusal_of(session, Adapt{.theta_min = Setting::of(30.0)}).empty());
    // A refused command sets none of its fields.
    EXPECT_FALSE(
        refusal_of(session, Adapt{.enabled = false, .theta_max = Setting::of(10.0)}).empty());
    expect_done(session, Readapt{});
    expect_done(session, Adapt{.theta_max = Setting::of(10.0), .theta_min = Setting::automatic()});
    EXPECT_FALSE(
        refusal_of(session, Adapt{.theta_max = Setting::of(10.0), .theta_min = Setting::of(10.0)})
            .empty());
    // With theta_max off there is no upper bound.
    expect_done(session, Adapt{.theta_max = Setting::off(), .theta_min = Setting::of(40.0)});
}

TEST(Session, ReadaptsWhenAskedThoughDragsDoNotAdapt) {
    Session session = sphere();
    expect_done(session, Adapt{.enabled = false});
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, drag(kTop, {0, 0.5, 0}));
    EXPECT_EQ(session.mesh().face_count(), faces);
    expect_done(session, Readapt{});
    EXPECT_GT(session.mesh().face_count(), faces);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
}

TEST(Session, RefusesCagesWithoutUsableCells) {
    Session session = sphere();
    EXPECT_FALSE(
        refusal_of(session,
                   Cage{.origin = Vec3{0.0}, .cell = Vec3{1, 0, 1}, .deformable = IVec3{2, 2, 2}})
            .empty());
    EXPECT_FALSE(
        refusal_of(session,
                   Cage{.origin = Vec3{0.0}, .cell = Vec3{1.0}, .deformable = IVec3{2, 0, 2}})
            .empty());
    EXPECT_FALSE(
        refusal_of(session,
                   Cage{.origin = Vec3{NAN}, .cell = Vec3{1.0}, .deformable = IVec3{2, 2, 2}})
            .empty());
    EXPECT_TRUE(contains(refusal_of(session, Cage{.fit = IVec3{2, 255, 2}}), "from 1 to 254"));
    EXPECT_TRUE(contains(refusal_of(session, Cage{.fit = IVec3{2, 0, 2}}), "from 1 to 254"));
    EXPECT_TRUE(contains(refusal_of(session, Cage{.origin = Vec3{0.0},
                                                  .cell = Vec3{1.0},
                                                  .deformable = IVec3{2, 255, 2},
                                                  .margin = IVec3{0, 1, 0}}),
                         "at most 256"));
    EXPECT_FALSE(refusal_of(session, Cage{.origin = Vec3{0.0},
                                          .cell = Vec3{1.0},
                                          .deformable = IVec3{2, 2, 2},
                                          .margin = IVec3{0, 3, 0}})
                     .empty());
}

TEST(Session, RefusesBrushesWithoutUsableSize) {
    Session session = sphere();
    for (double radius : {0.0, -1.0, double{NAN}, double{INFINITY}}) {
        EXPECT_TRUE(contains(refusal_of(session, Brush{.radius = radius}), "radius"));
    }
    for (int span : {0, -3, 257}) {
        EXPECT_TRUE(contains(refusal_of(session, Brush{.span = span}), "span"));
    }
    EXPECT_FALSE(refusal_of(session, Brush{.radius = 0.5, .span = 0}).empty());
    expect_done(session, drag(kTop, {0, 0.1, 0}));  // with the unchanged brush
    EXPECT_NEAR(session.lattice_in_use()->influenced_zone().max.x, 0.25 * std::sqrt(12.0), 1e-12);
}

TEST(Session, AsksForABrushIfTheObjectHasNoSize) {
    const auto path = std::filesystem::path(testing::TempDir()) / "pectin point.obj";
    std::ofstream(path) << "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n";
    Session session;
    expect_done(session, command::Open{.path = path.string()});
    std::filesystem::remove(path);
    EXPECT_TRUE(contains(refusal_of(session, drag({1, 2, 3}, {0, 1, 0})), "radius"));
    EXPECT_EQ(session.statistics().edge_max, 0.0);
    expect_done(session, Brush{.radius = 1.0});
    expect_done(session, drag({1, 2, 3}, {0, 1, 0}));
    EXPECT_EQ(session.mesh().position(VertexId{2}), Vec3(1, 3, 3));
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    expect_done(session, Cage{.fit = IVec3{2, 2, 2}});
}

TEST(Session, KeepsTheObjectIfAFileCannotBeOpened) {
    Session session = sphere();
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    const TriMesh before = session.mesh();
    EXPECT_ANY_THROW(std::ignore = session.execute(command::Open{.path = "/nowhere/none.obj"}));
    EXPECT_ANY_THROW(std::ignore = session.execute(command::Save{.path = "/nowhere/none.obj"}));
    EXPECT_TRUE(session.mesh() == before);
    expect_done(session, Undo{});
}

// --- Lattices

TEST(Session, FitsACageAroundTheObjectAndReturnsToTheBrush) {
    Session session = sphere();
    expect_done(session, Cage{.fit = IVec3{3, 5, 2}});
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    const Lattice cage = *session.lattice_in_use();
    EXPECT_EQ(cage.counts(), IVec3(3, 5, 2));
    EXPECT_NEAR(glm::distance(cage.rest({1, 1, 1}), Vec3{-1.0}), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(cage.rest({3, 5, 2}), Vec3{1.0}), 0.0, 1e-15);
    // The cage stays where it is when the object changes.
    expect_done(session, drag({1, 0, 0}, {0.1, 0, 0}));
    EXPECT_EQ(*session.lattice_in_use(), cage);
    expect_done(session, Brush{.radius = 0.5});
    expect_done(session, drag({0, 0, 1}, {0, 0, 0.1}));
    const Box zone = session.lattice_in_use()->influenced_zone();
    EXPECT_NEAR(glm::distance(zone.min, Vec3(-0.5, -0.5, 0.5)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(zone.max, Vec3(0.5, 0.5, 1.5)), 0.0, 1e-12);
}

TEST(Session, HasABrushOfAQuarterOfTheDiagonalAtStart) {
    Session session = sphere();
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    const double radius = 0.25 * std::sqrt(12.0);
    EXPECT_NEAR(session.lattice_in_use()->influenced_zone().max.x, radius, 1e-12);
    EXPECT_EQ(session.lattice_in_use()->deformable, IVec3(3));
    expect_done(session, Brush{.span = 5});
    expect_done(session, drag({1, 0, 0}, {0.1, 0, 0}));
    EXPECT_NEAR(session.lattice_in_use()->influenced_zone().max.y, radius, 1e-12);
    EXPECT_EQ(session.lattice_in_use()->deformable, IVec3(5));
}

TEST(Session, BringsDraggedPointsToTheirTargetsAndHoldsPins) {
    Session session = sphere();
    const VertexId x = vertex_at(session.mesh(), {1, 0, 0}), y = vertex_at(session.mesh(), kTop),
                   z = vertex_at(session.mesh(), {0, 0, 1});
    expect_done(session, Cage{.fit = IVec3{4, 4, 4}});
    expect_done(session, Drag{.moves = {{kTop, {0.1, 1.3, 0}}, {{0, 0, 1}, {0, 0.2, 0.8}}},
                              .pins = {{1, 0, 0}}});
    const TriMesh& mesh = session.mesh();
    EXPECT_LT(glm::distance(mesh.position(y), Vec3(0.1, 1.3, 0)), 1e-6);
    EXPECT_LT(glm::distance(mesh.position(z), Vec3(0, 0.2, 0.8)), 1e-6);
    EXPECT_LT(glm::distance(mesh.position(x), Vec3(1, 0, 0)), 1e-6);
}

// With such a lattice a twist once gave positions that were not finite.
TEST(Session, RefusesALatticeAMillionTimesTheSizeOfTheObject) {
    const Drag twist{
        .moves = {{.from = kTop, .to = kTop, .twist = Drag::Twist{{0.0, 0.0, 1.0}, 20.0}}}};
    for (const double size : {1e8, 1e154, 1e300}) {
        SCOPED_TRACE(size);
        Session session = sphere();
        expect_done(session, Brush{.radius = size});
        const Done done = session.execute(twist);
        ASSERT_FALSE(done);
        EXPECT_TRUE(contains(done.refusal().reason, "million times as large as the object"))
            << done.refusal().reason;
        const Done begun = session.execute(Cage{.cell = Vec3{size}, .deformable = IVec3{2}});
        const Done control =
            session.execute(command::Control{.points = {{IVec3{0}, Vec3{0.1 * size}}}});
        EXPECT_FALSE(begun && control);
        EXPECT_TRUE(session.mesh() == sphere().mesh());
        expect_done(session, Brush{.radius = 1.0});
        expect_done(session, twist);
    }
}

// --- Drags frame by frame

TEST(Session, EndsADragOfFramesWithTheBytesOfOneCommand) {
    Session script = sphere(), hand = sphere();
    const Drag whole = drag(kTop, {0.2, 0.4, 0});
    expect_done(script, whole);
    ASSERT_TRUE(hand.begin_drag(std::vector<Vec3>{kTop}, {}));
    for (double fraction : {0.3, 1.4, -0.2, 1.0}) {
        ASSERT_TRUE(hand.drag_to(std::vector<Vec3>{kTop + fraction * Vec3(0.2, 0.4, 0)}));
        EXPECT_TRUE(hand.is_dragging());
        EXPECT_EQ(hand.mesh().validate(), std::vector<std::string>{});
    }
    EXPECT_EQ(hand.end_drag(), whole);
    EXPECT_TRUE(hand.mesh() == script.mesh());
    expect_done(hand, Undo{});
    EXPECT_TRUE(hand.mesh() == sphere().mesh());
}

TEST(Session, RestoresEverythingIfADragIsCancelledOrReturns) {
    Session session = sphere();
    expect_done(session, drag({1, 0, 0}, {0.3, 0, 0}));
    const TriMesh before = session.mesh();
    for (const bool cancelled : {true, false}) {
        ASSERT_TRUE(session.begin_drag(std::vector<Vec3>{kTop}, {}));
        ASSERT_TRUE(session.drag_to(std::vector<Vec3>{{0, 1.5, 0}}));
        EXPECT_FALSE(session.mesh() == before);
        EXPECT_FALSE(session.drag_to(std::vector<Vec3>{{0, 1e9, 0}}));
        EXPECT_TRUE(session.is_dragging());
        if (cancelled) {
            session.cancel_drag();
        } else {
            ASSERT_TRUE(session.drag_to(std::vector<Vec3>{kTop}));
            EXPECT_FALSE(session.end_drag().has_value());
        }
        EXPECT_FALSE(session.is_dragging());
        EXPECT_TRUE(session.mesh() == before);
    }
    expect_done(session, Undo{});
    EXPECT_FALSE(refusal_of(session, Undo{}).empty());
}

// --- Statistics

double smallest_angle_deg(const TriMesh& mesh) {
    double smallest = 180.0;
    for (FaceId f : test::live_faces(mesh)) {
        Vec3 p[3];
        for (int c = 0; c < 3; ++c) p[c] = mesh.position(mesh.origin(TriMesh::half_edge(f, c)));
        for (int c = 0; c < 3; ++c) {
            const Vec3 u = glm::normalize(p[(c + 1) % 3] - p[c]);
            const Vec3 v = glm::normalize(p[(c + 2) % 3] - p[c]);
            const double angle = std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
            smallest = std::min(smallest, angle * 180.0 / std::numbers::pi);
        }
    }
    return smallest;
}

double greatest_divergence_deg(const TriMesh& mesh) {
    double greatest = 0.0;
    for (FaceId f : test::live_faces(mesh)) {
        for (int c = 0; c < 3; ++c) {
            const HalfEdgeId h = TriMesh::half_edge(f, c);
            if (!mesh.is_deformed(mesh.origin(h)) && !mesh.is_deformed(mesh.target(h))) continue;
            const Vec3 m{mesh.normal(mesh.wedge(h))}, n{mesh.normal(mesh.wedge(TriMesh::next(h)))};
            const double cosine = glm::dot(m, n);
            if (m == Vec3{0.0} || n == Vec3{0.0} || cosine < -0.5) continue;
            greatest = std::max(greatest, std::atan2(glm::length(glm::cross(m, n)), cosine));
        }
    }
    return greatest * 180.0 / std::numbers::pi;
}

void expect_figures_of_the_mesh(const Session& session) {
    const TriMesh& mesh = session.mesh();
    const Statistics s = session.statistics();
    std::uint64_t vertices = 0;
    int level = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (!mesh.is_live(VertexId{v})) continue;
        ++vertices;
        level = std::max(level, int{mesh.level(VertexId{v})});
    }
    double longest = 0.0;
    for (EdgeId e : test::live_edges(mesh)) {
        const HalfEdgeId h = mesh.half_edge(e);
        longest = std::max(
            longest, glm::distance(mesh.position(mesh.origin(h)), mesh.position(mesh.target(h))));
    }
    EXPECT_EQ(s.vertices, vertices);
    EXPECT_EQ(s.faces, test::live_faces(mesh).size());
    EXPECT_EQ(s.base_vertices, mesh.base_vertex_count());
    EXPECT_EQ(s.base_faces, mesh.base_face_count());
    EXPECT_EQ(s.max_level, level);
    EXPECT_NEAR(s.edge_max, longest, 1e-12 * longest);
    EXPECT_NEAR(s.angle_min_deg, smallest_angle_deg(mesh), 1e-5);
    EXPECT_NEAR(s.divergence_max_deg, greatest_divergence_deg(mesh), 0.05);
    EXPECT_GT(s.memory_bytes, 100 * s.vertices);
}

TEST(Session, ReportsStatisticsThatAScanOfTheMeshGives) {
    for (const Shape::Kind kind : {Shape::Kind::sphere, Shape::Kind::cube, Shape::Kind::cylinder}) {
        Session session;
        expect_done(session, shape(kind, 3));
        expect_figures_of_the_mesh(session);
        EXPECT_EQ(session.statistics().divergence_max_deg, 0.0);
        expect_done(session, drag(kTop, {0.1, 0.3, 0}));
        expect_figures_of_the_mesh(session);
        EXPECT_GT(session.statistics().divergence_max_deg, 1.0);
        EXPECT_GT(session.statistics().max_level, 0);
        EXPECT_GT(session.statistics().last.splits, 0u);
        expect_done(session, Undo{});
        expect_figures_of_the_mesh(session);
    }
}

TEST(Session, CountsInfluencedVerticesStrictlyInsideTheZone) {
    Session session = sphere(4);
    const TriMesh before = session.mesh();
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    const Box zone = session.lattice_in_use()->influenced_zone();
    std::uint64_t inside = 0;
    for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
        if (zone.contains_strictly(before.position(VertexId{v}))) ++inside;
    }
    EXPECT_EQ(session.statistics().last.influenced_vertices, inside);
}

TEST(Session, RefinesWhatIsThereByALowerThetaMaxWhenItReadapts) {
    Session session = sphere();
    expect_done(session, drag(kTop, {0, 0.3, 0}));
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    expect_done(session, Adapt{.theta_max = Setting::of(6.0)});
    const TriMesh before = session.mesh();
    expect_done(session, Readapt{});
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    EXPECT_GT(session.statistics().last.splits, 0u);
    expect_figures_of_the_mesh(session);
    EXPECT_LT(session.statistics().divergence_max_deg, 6.001);
    expect_done(session, Undo{});
    EXPECT_TRUE(session.mesh() == before);
}

TEST(Session, ReadaptsOnceAndThenFindsNothingMore) {
    for (const Shape::Kind kind : {Shape::Kind::sphere, Shape::Kind::cube, Shape::Kind::torus}) {
        Session session;
        expect_done(session, shape(kind, 3));
        expect_done(session, drag({1, 0, 0}, {0.2, 0.2, 0}));
        for (double theta : {8.0, 40.0, 15.0}) {
            expect_done(session, Adapt{.theta_max = Setting::of(theta)});
            expect_done(session, Readapt{});
            const TriMesh adapted = session.mesh();
            expect_done(session, Readapt{});
            EXPECT_EQ(session.statistics().last.splits, 0u);
            EXPECT_EQ(session.statistics().last.unsplits, 0u);
            EXPECT_TRUE(session.mesh() == adapted);
        }
    }
}

TEST(Session, BakesAsAStepThatUndoAndRedoExchange) {
    Session session = sphere();
    expect_done(session, drag({0, 0, 1}, {0, 0.2, 0.4}));
    const TriMesh refined = session.mesh();
    ASSERT_GT(refined.vertex_count(), refined.base_vertex_count());
    expect_done(session, command::Bake{});
    const TriMesh baked = session.mesh();
    EXPECT_EQ(baked.base_vertex_count(), refined.vertex_count());
    EXPECT_EQ(format_obj(baked), format_obj(refined));
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    EXPECT_TRUE(session.take_dirty().everything);
    // Nothing can be decimated now, and sculpting continues from here.
    expect_done(session, Adapt{.theta_max = Setting::off(), .l_max = Setting::off()});
    expect_done(session, Readapt{});
    EXPECT_TRUE(session.mesh() == baked);
    expect_done(session, drag({0, 1, 0}, {0, 0.4, 0}));
    const TriMesh dragged = session.mesh();
    expect_done(session, Undo{.count = 2});
    EXPECT_TRUE(session.mesh() == refined);
    expect_done(session, Undo{});
    EXPECT_EQ(session.mesh().vertex_count(), session.mesh().base_vertex_count());
    expect_done(session, command::Redo{.count = 3});
    EXPECT_TRUE(session.mesh() == dragged);
}

TEST(Session, TakesNoStepForABakeOfABaseMesh) {
    Session session = sphere();
    expect_done(session, command::Bake{});
    EXPECT_EQ(session.undo_count(), 0u);
    EXPECT_TRUE(contains(
        [] {
            Session none;
            return refusal_of(none, command::Bake{});
        }(),
        "no object"));
}

TEST(Session, TakesNoStepForAReadaptThatDoesNothing) {
    Session session = sphere();
    expect_done(session, Readapt{});
    EXPECT_FALSE(refusal_of(session, Undo{}).empty());
}

TEST(Session, ReadaptsToTheBaseMeshWithAllThresholdsOff) {
    Session session;
    expect_done(session, shape(Shape::Kind::torus, 3));
    const TriMesh base = session.mesh();
    expect_done(session, drag({1, 0, 0}, {0.3, 0.2, 0}));
    EXPECT_GT(session.mesh().face_count(), base.face_count());
    expect_done(session, Adapt{.theta_max = Setting::off(), .l_max = Setting::off()});
    expect_done(session, Readapt{});
    EXPECT_EQ(session.mesh().face_count(), base.face_count());
    EXPECT_EQ(session.mesh().vertex_count(), base.vertex_count());
    EXPECT_EQ(session.statistics().max_level, 0);
}

TEST(Session, CountsAngleOf180DegreesOrMoreAsOff) {
    for (const Setting& off : {Setting::off(), Setting::of(180.0), Setting::of(300.0)}) {
        Session session = sphere();
        expect_done(session, Adapt{.theta_max = off, .l_max = Setting::off()});
        const std::uint32_t faces = session.mesh().face_count();
        expect_done(session, drag(kTop, {0, 0.8, 0}));
        EXPECT_EQ(session.mesh().face_count(), faces);
    }
}

TEST(Session, ReportsThatTheBudgetWasHitAndWhatItHeldBack) {
    Session session = sphere();
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, Adapt{.theta_max = Setting::of(1.0), .budget = faces + 100});
    expect_done(session, drag(kTop, {0, 0.4, 0}));
    Statistics s = session.statistics();
    EXPECT_TRUE(s.budget_hit);
    EXPECT_EQ(s.needing_refinement, 0u);
    EXPECT_GT(s.held_back, 0u);
    EXPECT_LE(s.faces, faces + 100u);
    EXPECT_GE(s.faces, faces + 99u);
    // Refinement stays off until the next drag or change of settings.
    expect_done(session, Readapt{});
    EXPECT_EQ(session.statistics().last.splits, 0u);
    EXPECT_TRUE(session.statistics().budget_hit);
    expect_done(session, Adapt{.theta_max = Setting::of(20.0), .budget = 1'000'000});
    EXPECT_FALSE(session.statistics().budget_hit);
    expect_done(session, Readapt{});
    s = session.statistics();
    EXPECT_FALSE(s.budget_hit);
    EXPECT_EQ(s.held_back, 0u);
    EXPECT_EQ(s.needing_refinement, 0u);
}

TEST(Session, ForgetsABudgetHitWithTheStepThatHitIt) {
    Session session = sphere();
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    expect_done(session, Adapt{.theta_max = Setting::of(1.0), .budget = faces + 400});
    expect_done(session, drag(kTop + Vec3{0, 0.1, 0}, {0, 0.4, 0}));
    ASSERT_TRUE(session.statistics().budget_hit);
    expect_done(session, Undo{});
    EXPECT_FALSE(session.statistics().budget_hit);
    expect_done(session, Readapt{});
    EXPECT_TRUE(session.statistics().budget_hit) << "it is hit again";
    EXPECT_GT(session.statistics().last.splits, 0u);
}

TEST(Session, ForgetsABudgetHitForGoodOnceTheSettingsChange) {
    Session session = sphere();
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, Adapt{.theta_max = Setting::of(1.0), .budget = faces + 100});
    expect_done(session, drag(kTop, {0, 0.4, 0}));
    ASSERT_TRUE(session.statistics().budget_hit);
    expect_done(session, Adapt{.theta_max = Setting::of(20.0), .budget = 1'000'000});
    expect_done(session, drag({1, 0, 0}, {0.1, 0, 0}));
    expect_done(session, Undo{});
    EXPECT_FALSE(session.statistics().budget_hit);
    expect_done(session, Readapt{});
    EXPECT_GT(session.statistics().last.splits, 0u);
}

TEST(Session, ReportsThatTheFloorWasHitAndWhatItHeldBack) {
    Session session = sphere();
    expect_done(session, Adapt{.theta_max = Setting::of(2.0), .floor = Setting::of(0.05)});
    expect_done(session, drag(kTop, {0, 0.4, 0}));
    const Statistics s = session.statistics();
    EXPECT_TRUE(s.floor_hit);
    EXPECT_EQ(s.needing_refinement, 0u);
    EXPECT_GT(s.held_back, 0u);
    EXPECT_FALSE(s.budget_hit);
    expect_done(session, Adapt{.theta_max = Setting::of(40.0)});
    EXPECT_FALSE(session.statistics().floor_hit);
    EXPECT_EQ(session.statistics().held_back, s.held_back) << "of the last edit";
    expect_done(session, Readapt{});
    EXPECT_EQ(session.statistics().held_back, 0u);
}

TEST(Session, CountsFoldedVerticesOfTheLastDragOnly) {
    Session session = sphere();
    expect_done(session, Brush{.radius = 0.5});
    expect_done(session, drag(kTop, {0, 0.1, 0}));
    EXPECT_EQ(session.statistics().folded_vertices, 0u);
    expect_done(session, drag({1, 0, 0}, {0, 0.9, 0}));
    EXPECT_GT(session.statistics().folded_vertices, 0u);
    expect_done(session, drag({0, 0, 1}, {0, 0, 0.05}));
    EXPECT_EQ(session.statistics().folded_vertices, 0u);
}

}  // namespace
}  // namespace pectin

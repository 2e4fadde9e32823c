// Symmetry, connected parts, twists and control points, as commands of a session.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "command/json.h"
#include "ffd/lattice_field.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Cage;
using command::Control;
using command::Drag;
using command::Redo;
using command::Shape;
using command::Undo;
using Plane = command::Symmetry::Plane;

using test::expect_done;

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

Session session_with(Shape::Kind kind, int resolution, double radius) {
    Session session;
    expect_done(session, Shape{kind, resolution});
    expect_done(session, Brush{.radius = radius});
    return session;
}

std::vector<Vec3> positions(const TriMesh& mesh) {
    std::vector<Vec3> all;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (mesh.is_live(VertexId{v})) all.push_back(mesh.position(VertexId{v}));
    }
    return all;
}

// --- Symmetry

TEST(SymmetricSession, KeepsASymmetricMeshSymmetricOverFortyDrags) {
    for (const bool adapts : {false, true}) {
        test::Random random(104);
        Session session = session_with(Shape::Kind::sphere, 3, 0.5);
        expect_done(session, Adapt{.enabled = adapts});
        expect_done(session, command::Symmetry{.plane = Plane::x});
        int done = 0;
        for (int i = 0; i < 40; ++i) {
            const std::vector<Vec3> all = positions(session.mesh());
            const Vec3 from =
                all[static_cast<std::size_t>(random.integer(0, static_cast<int>(all.size()) - 1))];
            const Vec3 direction = random.direction();  // the order of evaluation is unspecified
            Vec3 to = from + random.uniform(0.02, 0.15) * direction;
            if (std::abs(from.x) < 1e-6) to.x = from.x;
            if (to.x * from.x < 0.0) to.x = from.x;
            const Drag drag{.moves = {{from, to}}, .fold_free = i % 2 == 0};
            if (session.execute(drag)) ++done;
        }
        EXPECT_GT(done, 30);
        if (adapts) {
            EXPECT_GT(session.mesh().face_count(), 1300u);
        }
        EXPECT_FALSE(session.outcome().has_ended_at_budget());
        EXPECT_LT(test::asymmetry(session.mesh()), 1e-6 * session.mesh().bounding_box().diagonal());
        EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    }
}

// Refined by angle, so that refinement does not depend on the zone. So many edges are split at once
// that they are divided into partitions.
TEST(SymmetricSession, KeepsALargeMeshSymmetricWhereThousandsAreSplit) {
    Session session = session_with(Shape::Kind::sphere, 5, 1.6);
    expect_done(session, Adapt{.theta_max = Setting::of(1.5)});
    expect_done(session, command::Symmetry{.plane = Plane::x});
    expect_done(session, Drag{.moves = {{{0.6, 0, 0.8}, {1.0, 0.3, 1.5}}}});
    EXPECT_GT(session.mesh().face_count(), 80'000u);
    EXPECT_LT(test::asymmetry(session.mesh()), 1e-6 * session.mesh().bounding_box().diagonal());
    expect_done(session, Drag{.moves = {{{0, 1, 0}, {0, 1.8, 0.2}}}});
    EXPECT_LT(test::asymmetry(session.mesh()), 1e-6 * session.mesh().bounding_box().diagonal());
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
}

TEST(SymmetricSession, MovesBothSidesAndKeepsThePlane) {
    Session session = session_with(Shape::Kind::sphere, 4, 0.4);
    expect_done(session, command::Symmetry{.plane = Plane::y});
    std::vector<Vec3> before = positions(session.mesh());
    const std::size_t count = before.size();
    expect_done(session, Drag{.moves = {{{0, 1, 0}, {0.1, 1.3, 0}}}});
    const std::vector<Vec3> after = positions(session.mesh());
    for (std::size_t i = 0; i < count; ++i) {
        if (before[i] == Vec3(0, 1, 0)) {
            EXPECT_LT(glm::distance(after[i], Vec3(0.1, 1.3, 0)), 1e-6);
        }
        if (before[i] == Vec3(0, -1, 0)) {
            EXPECT_LT(glm::distance(after[i], Vec3(0.1, -1.3, 0)), 1e-6);
        }
    }
    expect_done(session, Drag{.moves = {{{1, 0, 0}, {1.4, 0, 0.2}}}, .fold_free = true});
    const std::vector<Vec3> later = positions(session.mesh());
    for (std::size_t i = 0; i < count; ++i) {
        if (before[i].y == 0.0) {
            EXPECT_EQ(later[i].y, 0.0);
        }
    }
}

TEST(SymmetricSession, RefusesToGoAcrossUntilItIsSwitchedOff) {
    Session session = session_with(Shape::Kind::sphere, 3, 0.5);
    expect_done(session, command::Symmetry{.plane = Plane::x, .through = {0.25, 7, 7}});
    const Drag across{.moves = {{{0, 0, 1}, {0.5, 0, 1}}}};
    EXPECT_TRUE(contains(refusal_of(session, across), "(0.25, 0, 1)"));
    ASSERT_TRUE(session.begin_drag(std::vector<Vec3>{{0, 0, 1}}, {}));
    EXPECT_FALSE(session.drag_to(std::vector<Vec3>{{0.5, 0, 1}}));
    ASSERT_TRUE(session.drag_to(std::vector<Vec3>{{0.1, 0, 1}}));
    EXPECT_TRUE(session.end_drag().has_value());
    expect_done(session, command::Symmetry{});
    expect_done(session, across);
}

// --- Connected

std::string two_sheets() {
    std::ostringstream out;
    constexpr int kSide = 21;
    for (const double y : {0.0, 0.1}) {
        for (int i = 0; i < kSide * kSide; ++i) {
            out << "v " << -1.0 + 0.1 * (i % kSide) << " " << y << " " << -1.0 + 0.1 * (i / kSide)
                << "\n";
        }
    }
    for (int sheet = 0; sheet < 2; ++sheet) {
        for (int j = 0; j + 1 < kSide; ++j) {
            for (int i = 0; i + 1 < kSide; ++i) {
                const int v = sheet * kSide * kSide + j * kSide + i + 1;
                out << "f " << v << " " << v + kSide << " " << v + kSide + 1 << " " << v + 1
                    << "\n";
            }
        }
    }
    return out.str();
}

void open_two_sheets(Session& session) {
    const ScratchFolder folder;
    folder.write("sheets.obj", two_sheets());
    expect_done(session, command::Open{folder.path("sheets.obj")});
}

TEST(ConnectedDrag, DoesNotMoveADisconnectedSheetWithinTheRadius) {
    for (const bool fold_free : {false, true}) {
        Session session;
        open_two_sheets(session);
        expect_done(session, Brush{.radius = 0.6});
        const TriMesh before = session.mesh();
        const Drag drag{
            .moves = {{{0, 0.1, 0}, {0, 0.9, 0}}}, .connected = true, .fold_free = fold_free};
        expect_done(session, drag);
        EXPECT_GT(session.statistics().last.splits, 0u);
        std::size_t moved = 0;
        for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
            const Vec3 was = before.position(VertexId{v}),
                       is = session.mesh().position(VertexId{v});
            if (was.y == 0.0) {
                EXPECT_EQ(was, is);
            }
            moved += was == is ? 0 : 1;
        }
        EXPECT_GT(moved, 50u);
        for (std::uint32_t v = before.vertex_slots(); v < session.mesh().vertex_slots(); ++v) {
            EXPECT_GT(session.mesh().position(VertexId{v}).y, 0.0) << "split on the other sheet";
        }
        const TriMesh after = session.mesh();
        expect_done(session, Undo{});
        EXPECT_TRUE(session.mesh() == before);
        expect_done(session, Redo{});
        EXPECT_TRUE(session.mesh() == after);
        // Without `connected` the lower sheet moves, too.
        expect_done(session, Undo{});
        expect_done(session, Drag{.moves = drag.moves});
        double highest = 0.0;
        for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
            if (before.position(VertexId{v}).y == 0.0) {
                highest = std::max(highest, session.mesh().position(VertexId{v}).y);
            }
        }
        EXPECT_GT(highest, 0.1);
    }
}

TEST(ConnectedDrag, MovesThePartOfEveryHandleAndOfItsMirrorImage) {
    Session session;
    open_two_sheets(session);
    expect_done(session, Brush{.radius = 0.6});
    const TriMesh before = session.mesh();
    expect_done(session, command::Symmetry{.plane = Plane::y, .through = {0, 0.05, 0}});
    expect_done(session, Drag{.moves = {{{0, 0.1, 0}, {0.1, 0.2, 0}}}, .connected = true});
    std::size_t lower = 0;
    for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
        const bool moved = before.position(VertexId{v}) != session.mesh().position(VertexId{v});
        lower += moved && before.position(VertexId{v}).y == 0.0 ? 1 : 0;
    }
    EXPECT_GT(lower, 20u);
}

// --- Twist and scale

TEST(TwistedSession, RotatesAndScalesTheSurfaceAtThePoint) {
    Session session = session_with(Shape::Kind::plane, 200, 0.5);
    expect_done(session, Adapt{.enabled = false});
    const std::vector<Vec3> before = positions(session.mesh());
    expect_done(session, Drag{.moves = {{.from = {0, 0, 0},
                                         .to = {0, 0.1, 0},
                                         .twist = Drag::Twist{{0, 1, 0}, 150.0},
                                         .scale = 1.5}},
                              .fold_free = true});
    EXPECT_GT(session.statistics().last.steps, 1u);
    const std::vector<Vec3> after = positions(session.mesh());
    const double c = -std::sqrt(0.75), s = 0.5;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (glm::length(before[i]) > 0.0105) continue;
        const Vec3 rotated =
            1.5 * Vec3{c * before[i].x + s * before[i].z, 0.0, -s * before[i].x + c * before[i].z};
        EXPECT_LT(glm::distance(after[i], rotated + Vec3(0, 0.1, 0)), 1.5e-3);
    }
}

// --- Lattices for display

// The lattices that the window draws are those that move the object, on both sides.
TEST(ActiveLattices, MoveTheSurfaceAsTheFrameDid) {
    for (const double x : {0.0, 0.1, 0.9}) {
        Session session = session_with(Shape::Kind::sphere, 4, 0.6);
        expect_done(session, Adapt{.enabled = false});
        expect_done(session, command::Symmetry{.plane = Plane::x});
        if (x == 0.9) expect_done(session, Cage{.fit = IVec3{4, 3, 5}});
        const std::vector<Vec3> before = positions(session.mesh());
        const Vec3 from{x, 0, std::sqrt(1.0 - x * x)};
        ASSERT_TRUE(session.begin_drag(std::array{from}, std::array{Vec3{0.3, 0.3, 0.9}}));
        const Vec3 axis = x == 0.0 ? Vec3{1, 0, 0} : Vec3{1, 2, 3};
        const Move move{from, from + Vec3{0, 0.1, 0.2}, Twist{axis, 40.0}, 1.2};
        ASSERT_TRUE(session.drag_to(std::array{move}));
        const std::vector<LatticeField> fields = session.active_lattices();
        EXPECT_EQ(fields.size(), x == 0.1 ? 2u : 1u) << x;
        const std::vector<Vec3> after = positions(session.mesh());
        double farthest = 0.0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            Vec3 expected = before[i];
            for (const LatticeField& field : fields) expected += field.displacement(before[i]);
            EXPECT_LT(glm::distance(after[i], expected), 1e-6);
            farthest = std::max(farthest, glm::distance(after[i], before[i]));
        }
        EXPECT_GT(farthest, 0.2);
        session.cancel_drag();
    }
}

TEST(ActiveLattices, OfAControlPointDragAreTheCage) {
    Session session = session_with(Shape::Kind::sphere, 2, 0.6);
    expect_done(session, Cage{.fit = IVec3{3, 3, 3}});
    ASSERT_TRUE(session.begin_control(std::array{IVec3{1, 1, 2}}));
    ASSERT_TRUE(session.control_to(std::array{Vec3{0, 0, 1.5}}));
    const std::vector<LatticeField> fields = session.active_lattices();
    ASSERT_EQ(fields.size(), 1u);
    const std::size_t at = fields[0].lattice().control_index({2, 2, 3});
    EXPECT_LT(glm::distance(fields[0].displacements()[at], Vec3(0, 0, 0.5)), 1e-12);
    session.cancel_drag();
}

// --- Control points

const Cage kCage{.origin = Vec3{-1.0}, .cell = Vec3{1.0}, .deformable = IVec3{3, 3, 3}};

TEST(ControlPoints, DeformByTheLatticeFieldAndAreUndoneByteForByte) {
    Session session = session_with(Shape::Kind::sphere, 3, 0.5);
    expect_done(session, Adapt{.enabled = false});
    expect_done(session, kCage);
    const TriMesh before = session.mesh();
    const Control control{{{{2, 1, 1}, {1.8, 0.2, 0}}, {{1, 2, 1}, {0, 0.4, 0}}}};
    expect_done(session, control);
    const Lattice lattice{.origin = Vec3{-1.0}, .cell = Vec3{1.0}, .deformable = {3, 3, 3}};
    std::vector<Vec3> displacements(27, Vec3{0.0});
    displacements[lattice.control_index({2, 1, 1})] = {0.8, 0.2, 0};
    displacements[lattice.control_index({1, 2, 1})] = {0, -0.6, 0};
    const LatticeField field(lattice, displacements);
    for (std::uint32_t v = 0; v < before.vertex_slots(); ++v) {
        const Vec3 x = before.position(VertexId{v});
        EXPECT_LT(glm::distance(session.mesh().position(VertexId{v}), x + field.displacement(x)),
                  1e-15);
    }
    EXPECT_EQ(session.lattice_in_use(), lattice);
    expect_done(session, Undo{});
    EXPECT_TRUE(session.mesh() == before);
}

TEST(ControlPoints, RefineAdaptivelyAndEndFramesWithTheBytesOfTheCommand) {
    Session hand = session_with(Shape::Kind::sphere, 3, 0.5);
    Session script = session_with(Shape::Kind::sphere, 3, 0.5);
    for (Session* session : {&hand, &script}) {
        expect_done(*session, kCage);
        expect_done(*session, Adapt{.theta_max = Setting::of(8.0)});
    }
    const std::vector<IVec3> indices{{2, 1, 1}, {1, 1, 2}};
    ASSERT_TRUE(hand.begin_control(indices));
    for (const double fraction : {0.5, 1.6, 1.0}) {
        ASSERT_TRUE(hand.control_to(std::vector<Vec3>{{1.0 + fraction, 0, 0}, {0, fraction, 1}}));
        EXPECT_EQ(hand.mesh().validate(), std::vector<std::string>{});
    }
    const auto control = hand.end_control();
    ASSERT_TRUE(control.has_value());
    EXPECT_GT(hand.statistics().last.splits, 0u);
    EXPECT_EQ(hand.statistics().needing_refinement, 0u);
    EXPECT_EQ(hand.statistics().last.steps, 1u);
    expect_done(script, std::get<Command>(parse_command(format_command(*control))));
    EXPECT_TRUE(hand.mesh() == script.mesh());
    // The cage can be fitted again to the deformed surface.
    expect_done(hand, Cage{.fit = IVec3{4, 2, 3}});
    expect_done(hand, Control{{{{3, 1, 2}, {3, 2, 1}}}});
    expect_done(hand, Undo{2});
    EXPECT_TRUE(hand.begin_control(indices));
    hand.cancel_drag();
}

TEST(ControlPoints, CountFoldsAndDoNothingIfTheyDoNotMove) {
    Session session = session_with(Shape::Kind::sphere, 3, 0.5);
    expect_done(session, kCage);
    expect_done(session, Control{{{{1, 1, 1}, {0, 0, 0}}}});
    EXPECT_EQ(session.undo_count(), 0u);
    expect_done(session, Control{{{{2, 1, 1}, {-60, 0, 0}}}});
    EXPECT_GT(session.statistics().folded_vertices, 0u);
}

TEST(ControlPoints, AreSymmetricIfTheCageIs) {
    Session session = session_with(Shape::Kind::sphere, 3, 0.5);
    expect_done(session, kCage);
    expect_done(session, command::Symmetry{.plane = Plane::x});
    expect_done(session, Control{{{{2, 1, 1}, {1.7, 0.2, 0}}, {{1, 2, 1}, {0, 1.5, 0.3}}}});
    EXPECT_LT(test::asymmetry(session.mesh()), 1e-6);
    EXPECT_TRUE(contains(refusal_of(session, Control{{{{1, 1, 1}, {0.5, 1, 2}}}}), "(0, 1, 2)"));
    EXPECT_TRUE(
        contains(refusal_of(session, Control{{{{0, 1, 1}, {-1, 1, 0}}, {{2, 1, 1}, {1, 2, 0}}}}),
                 "each once"));
    expect_done(session,
                Cage{.origin = Vec3{0, 0, 0}, .cell = Vec3{1.0}, .deformable = IVec3{3, 3, 3}});
    EXPECT_TRUE(contains(refusal_of(session, Control{{{{1, 1, 1}, {1, 1, 2}}}}), "mirror image"));
}

TEST(ControlPoints, ThatDoNotExistAreRefused) {
    Session session = session_with(Shape::Kind::sphere, 2, 0.5);
    EXPECT_TRUE(contains(refusal_of(session, Control{{{{0, 0, 0}, {0, 0, 0}}}}), "cage command"));
    expect_done(session, kCage);
    EXPECT_TRUE(contains(refusal_of(session, Control{{{{0, 3, 0}, {0, 0, 0}}}}), "[2, 2, 2]"));
    EXPECT_TRUE(contains(refusal_of(session, Control{{{{0, -1, 0}, {0, 0, 0}}}}), "[2, 2, 2]"));
    EXPECT_TRUE(contains(
        refusal_of(session, Control{{{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}}}), "once"));
    EXPECT_FALSE(refusal_of(session, Control{}).empty());
    EXPECT_FALSE(refusal_of(session, Control{{{{0, 0, 0}, {1e30, 0, 0}}}}).empty());
}

// The mirror images of lattices about such a plane overflow.
TEST(SymmetricSession, RefusesToDragWithAPlaneAMillionTimesTheSizeOfTheObjectAway) {
    for (const double at : {1e9, -1e9, 1e300}) {
        SCOPED_TRACE(at);
        Session session;
        ASSERT_TRUE(session.execute(command::Shape{command::Shape::Kind::sphere, 1}));
        const TriMesh before = session.mesh();
        ASSERT_TRUE(session.execute(
            command::Symmetry{.plane = command::Symmetry::Plane::y, .through = Vec3{at}}));
        for (const bool fold_free : {false, true}) {
            const Done done = session.execute(
                command::Drag{.moves = {{Vec3{0, 0, 1}, Vec3{0, 0, 1.5}}}, .fold_free = fold_free});
            ASSERT_FALSE(done);
            EXPECT_NE(done.refusal().reason.find("the symmetry plane"), std::string::npos)
                << done.refusal().reason;
            EXPECT_TRUE(session.mesh() == before);
        }
    }
}

}  // namespace
}  // namespace pectin

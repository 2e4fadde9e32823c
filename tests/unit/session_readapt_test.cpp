// Tests where the readapt command refines by length. A length that the user sets applies
// everywhere.
#include <gtest/gtest.h>

#include <string>

#include "command/json.h"
#include "session/session.h"
#include "support/expect_done.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Brush;
using command::Cage;
using command::Drag;
using command::Readapt;
using command::Shape;

using test::expect_done;

void expect_short_edges_everywhere(Session& session, double l_max) {
    expect_done(session, Readapt{});
    EXPECT_LE(session.statistics().edge_max, l_max);
    EXPECT_GT(session.statistics().last.splits, 0u);
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    const std::size_t steps = session.undo_count();
    expect_done(session, Readapt{});
    EXPECT_EQ(session.undo_count(), steps) << "nothing is left to do";
}

TEST(Readapt, RefinesAnObjectThatHasNotBeenDraggedByAGivenLength) {
    for (const auto kind : {Shape::Kind::sphere, Shape::Kind::plane, Shape::Kind::torus}) {
        Session session;
        expect_done(session, Shape{kind, 2});
        const TriMesh before = session.mesh();
        expect_done(session, Adapt{.l_max = Setting::of(0.15)});
        expect_short_edges_everywhere(session, 0.15);
        EXPECT_EQ(session.undo_count(), 1u);
        expect_done(session, command::Undo{});
        EXPECT_TRUE(session.mesh() == before);
    }
}

TEST(Readapt, RefinesTheWholeObjectByAGivenLengthWhateverLatticeIsSet) {
    const Command small_cage =
        Cage{.origin = Vec3{0.9}, .cell = Vec3{0.05}, .deformable = IVec3{2}};
    for (const Command& lattice :
         {Command{Brush{.radius = 0.1}}, Command{Cage{.fit = IVec3{3}}}, small_cage}) {
        Session session;
        expect_done(session, Shape{Shape::Kind::sphere, 2});
        expect_done(session, lattice);
        expect_done(session, Adapt{.l_max = Setting::of(0.2)});
        expect_short_edges_everywhere(session, 0.2);
    }
}

TEST(Readapt, RefinesTheWholeObjectByAGivenLengthAfterALocalDrag) {
    for (const bool connected : {false, true}) {
        Session session;
        expect_done(session, Shape{Shape::Kind::sphere, 2});
        expect_done(session, Brush{.radius = 0.3});
        expect_done(session, Drag{.moves = {{{0, 1, 0}, {0, 1.1, 0}}}, .connected = connected});
        expect_done(session, Adapt{.l_max = Setting::of(0.2)});
        expect_short_edges_everywhere(session, 0.2);
    }
}

TEST(Readapt, RefinesByTheCellExtentOnlyInTheZoneOfTheLastDrag) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, 2});
    expect_done(session, Readapt{});
    EXPECT_EQ(session.undo_count(), 0u) << "there is no lattice whose cells count";
    expect_done(session, Adapt{.theta_max = Setting::off(), .l_max = Setting::off()});
    expect_done(session, Brush{.radius = 0.3});
    expect_done(session, Drag{.moves = {{{0, 1, 0}, {0, 1.02, 0}}}});
    const double before = session.statistics().edge_max;
    expect_done(session, Adapt{.l_max = Setting::automatic()});
    expect_done(session, Readapt{});
    EXPECT_GT(session.statistics().last.splits, 0u);
    EXPECT_NEAR(session.statistics().edge_max, before, 1e-2) << "edges elsewhere stay";
}

}  // namespace
}  // namespace pectin

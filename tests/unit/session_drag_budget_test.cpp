// The budget of one drag: how many triangles it may add.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "adapt/defaults.h"
#include "session/session.h"
#include "support/expect_done.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Drag;
using command::Readapt;
using command::Shape;
using command::Undo;

using test::expect_done;

// A sphere of 1,280 faces, which a drag would have to split into many more.
Session sphere(const Setting& drag_budget) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, 3});
    expect_done(session, Adapt{.theta_max = Setting::of(2.0), .drag_budget = drag_budget});
    expect_done(session, command::Brush{.radius = 0.8});
    return session;
}

Drag upwards(double from, double to) { return {.moves = {{Vec3{0, from, 0}, Vec3{0, to, 0}}}}; }

TEST(DragBudget, EndsTheRefinementOfADragAndSaysSo) {
    Session session = sphere(Setting::of(500));
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, upwards(1.0, 1.4));
    const Statistics s = session.statistics();
    EXPECT_TRUE(s.drag_budget_hit);
    EXPECT_FALSE(s.budget_hit);
    EXPECT_LE(s.faces, faces + 500u);
    EXPECT_GE(s.faces, faces + 498u);
    EXPECT_EQ(s.needing_refinement, 0u);
    EXPECT_GT(s.held_back, 0u);
    EXPECT_NE(session.remark().find("triangle budget of the drag"), std::string::npos)
        << session.remark();
    EXPECT_NE(session.remark().find("a larger budget"), std::string::npos) << session.remark();
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    // Refinement stays off until the settings change.
    expect_done(session, Readapt{});
    EXPECT_EQ(session.statistics().last.splits, 0u);
    EXPECT_TRUE(session.statistics().drag_budget_hit);
    EXPECT_FALSE(session.statistics().budget_hit);
}

TEST(DragBudget, IsThatOfEachDrag) {
    Session session = sphere(Setting::of(500));
    expect_done(session, upwards(1.0, 1.4));
    const std::uint32_t after_first = session.mesh().face_count();
    expect_done(session, upwards(1.4, 1.5));
    EXPECT_TRUE(session.statistics().drag_budget_hit);
    EXPECT_GT(session.mesh().face_count(), after_first + 400);
    expect_done(session, Undo{});
    expect_done(session, Undo{});
    EXPECT_FALSE(session.statistics().drag_budget_hit);
    EXPECT_EQ(session.remark(), "");
}

// Otherwise readapt would refine all of what the first drag has left coarse.
TEST(DragBudget, IsRememberedUntilTheSettingsChange) {
    Session session = sphere(Setting::of(500));
    expect_done(session, Adapt{.l_max = Setting::off()});
    expect_done(session, upwards(1.0, 1.4));
    expect_done(session, command::Brush{.radius = 0.05});
    const std::uint32_t after_first = session.mesh().face_count();
    expect_done(session, Drag{.moves = {{Vec3{0, -1, 0}, Vec3{0, -1.0001, 0}}}});
    ASSERT_LT(session.mesh().face_count(), after_first + 498) << "stays within its own budget";
    EXPECT_TRUE(session.statistics().drag_budget_hit);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    expect_done(session, Readapt{});
    EXPECT_EQ(session.statistics().last.splits, 0u);
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, Adapt{.theta_max = Setting::of(1.9)});
    EXPECT_FALSE(session.statistics().drag_budget_hit);
    expect_done(session, Readapt{});
    EXPECT_TRUE(session.statistics().drag_budget_hit) << "readapt has the same limit";
    EXPECT_GT(session.mesh().face_count(), faces);
    EXPECT_LE(session.mesh().face_count(), faces + 500);
}

TEST(DragBudget, IsThatOfControlPointsToo) {
    Session session = sphere(Setting::of(500));
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, command::Cage{.fit = IVec3{3, 3, 3}});
    expect_done(session, command::Control{{{{1, 2, 1}, Vec3{0.3, 3.0, 0}}}});
    EXPECT_TRUE(session.statistics().drag_budget_hit);
    EXPECT_LE(session.mesh().face_count(), faces + 500);
}

TEST(DragBudget, HoldsInEachFrame) {
    Session session = sphere(Setting::of(500));
    const std::uint32_t faces = session.mesh().face_count();
    ASSERT_TRUE(session.begin_drag(std::vector<Vec3>{{0, 1, 0}}, {}));
    for (const double to : {1.1, 1.3, 1.5}) {
        ASSERT_TRUE(session.drag_to(std::vector<Vec3>{{0, to, 0}}));
        EXPECT_LE(session.mesh().face_count(), faces + 500);
    }
    EXPECT_TRUE(session.last_frame().drag_budget_hit);
    session.cancel_drag();
    EXPECT_EQ(session.mesh().face_count(), faces);
}

TEST(DragBudget, GivesWayToTheBudgetOfTheObject) {
    Session session = sphere(Setting::of(500));
    expect_done(session, Adapt{.budget = session.mesh().face_count() + 300});
    expect_done(session, upwards(1.0, 1.4));
    EXPECT_TRUE(session.statistics().budget_hit);
    EXPECT_FALSE(session.statistics().drag_budget_hit);
    EXPECT_EQ(session.remark(), "");
}

TEST(DragBudget, CanBeOff) {
    Session session = sphere(Setting::off());
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, upwards(1.0, 1.4));
    EXPECT_FALSE(session.statistics().drag_budget_hit);
    EXPECT_GT(session.mesh().face_count(), faces + 2000);
    EXPECT_EQ(session.statistics().held_back, 0u);
}

TEST(DragBudget, FollowsByDefaultFromTheFacesThatTheDragMoves) {
    EXPECT_EQ(default_drag_budget(0), 200'000u);
    EXPECT_EQ(default_drag_budget(50'000), 200'000u);
    EXPECT_EQ(default_drag_budget(50'001), 200'004u);
    const AdaptSettings automatic;
    EXPECT_EQ(automatic.drag_budget_for(1'000'000), 4'000'000u);
    AdaptSettings set;
    set.drag_budget = Setting::of(7);
    EXPECT_EQ(set.drag_budget_for(1'000'000), 7u);
    set.drag_budget = Setting::off();
    EXPECT_FALSE(set.drag_budget_for(1).has_value());
}

}  // namespace
}  // namespace pectin

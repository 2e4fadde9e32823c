// The memory of the history: how it is counted and reported, and how the limit is kept.
#include "session/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "command/json.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "session/session.h"
#include "support/expect_done.h"

namespace pectin {
namespace {

using command::Adapt;
using command::Drag;
using command::Redo;
using command::Shape;
using command::Undo;

using test::expect_done;

using test::refusal_of;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

command::History megabytes(double number) { return {Setting::of(number)}; }

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
const std::vector<Vec3> kTips{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};

// A sphere with a drag at each of four tips, and the meshes before and after each drag.
struct FourDrags {
    FourDrags() {
        expect_done(session, Shape{Shape::Kind::sphere, 3});
        after.push_back(session.mesh());
        for (const Vec3& tip : kTips) {
            expect_done(session, Drag{.moves = {{tip, 1.2 * tip}}});
            after.push_back(session.mesh());
            bytes.push_back(session.history().memory_bytes());
        }
    }
    // A limit that exactly the last `steps` steps fit into.
    command::History history_limit_for(std::size_t steps) const {
        const std::size_t gone = steps < 4 ? bytes[3 - steps] : 0;
        return megabytes(1e-6 * static_cast<double>(bytes[3] - gone) + 1e-9);
    }
    Session session;
    std::vector<TriMesh> after;
    std::vector<std::size_t> bytes;  // after the first, second, ... drag
};

TEST(HistoryLimit, IsAThousandMegabytesAtStart) {
    EXPECT_EQ(Session().history().limit(), 1'000'000'000u);
    EXPECT_EQ(History::kDefaultLimit, 1'000'000'000u);
}

TEST(HistoryLimit, DropsTheOldestStepsAtOnceAndNoMoreThanItMust) {
    FourDrags drags;
    const History& history = drags.session.history();
    expect_done(drags.session, drags.history_limit_for(4));
    EXPECT_EQ(history.undo_count(), 4u);
    expect_done(drags.session, drags.history_limit_for(3));
    EXPECT_EQ(history.undo_count(), 3u);
    expect_done(drags.session, drags.history_limit_for(2));
    EXPECT_EQ(history.undo_count(), 2u);
    EXPECT_EQ(history.lost_undo_count(), 2u);
    EXPECT_EQ(history.step_number(), 4u);
    expect_done(drags.session, Undo{.count = 2});
    EXPECT_TRUE(drags.session.mesh() == drags.after[2]);
    EXPECT_TRUE(contains(refusal_of(drags.session, Undo{}),
                         "only 0 steps to undo, not 1; 2 older steps were dropped"));
    expect_done(drags.session, Redo{.count = 2});
    EXPECT_TRUE(drags.session.mesh() == drags.after[4]);
}

TEST(HistoryLimit, KeepsTheNewestStepHoweverLargeItIs) {
    FourDrags drags;
    expect_done(drags.session, megabytes(1e-6));
    EXPECT_EQ(drags.session.history().undo_count(), 1u);
    expect_done(drags.session, Drag{.moves = {{{-1, 0, 0}, {-1.3, 0, 0}}}});
    EXPECT_EQ(drags.session.history().undo_count(), 1u);
    EXPECT_EQ(drags.session.history().lost_undo_count(), 4u);
    expect_done(drags.session, Undo{});
    EXPECT_TRUE(drags.session.mesh() == drags.after[4]);
}

TEST(HistoryLimit, IsASettingThatTakesNoStepAndKeepsRedo) {
    FourDrags drags;
    expect_done(drags.session, Undo{.count = 2});
    expect_done(drags.session, drags.history_limit_for(3));
    EXPECT_EQ(drags.session.history().undo_count(), 1u);
    EXPECT_EQ(drags.session.history().redo_count(), 2u);
    expect_done(drags.session, command::History{});  // changes nothing
    EXPECT_TRUE(drags.session.history().limit());
    expect_done(drags.session, command::History{Setting::off()});
    EXPECT_FALSE(drags.session.history().limit());
    expect_done(drags.session, Redo{.count = 2});
    EXPECT_TRUE(drags.session.mesh() == drags.after[4]);
}

TEST(HistoryLimit, KeepsEveryStepThatCanBeRedone) {
    FourDrags drags;
    expect_done(drags.session, Undo{.count = 3});
    expect_done(drags.session, megabytes(1e-6));
    EXPECT_EQ(drags.session.history().undo_count(), 0u);
    EXPECT_EQ(drags.session.history().lost_undo_count(), 1u);
    ASSERT_EQ(drags.session.history().redo_count(), 3u);
    EXPECT_TRUE(contains(refusal_of(drags.session, Redo{.count = 4}), "only 3 steps to redo"));
    expect_done(drags.session, Redo{});
    EXPECT_TRUE(drags.session.mesh() == drags.after[2]);
    expect_done(drags.session, Redo{.count = 2});
    EXPECT_TRUE(drags.session.mesh() == drags.after[4]);
    // The limit now applies to the steps that were redone. The newest one is kept.
    EXPECT_EQ(drags.session.history().undo_count(), 1u);
    EXPECT_EQ(drags.session.history().lost_undo_count(), 3u);
    expect_done(drags.session, Undo{});
    EXPECT_TRUE(drags.session.mesh() == drags.after[3]);
    EXPECT_TRUE(contains(refusal_of(drags.session, Redo{.count = 2}), "there is only 1 step to"));
}

TEST(HistoryLimit, ReportsWhenItDropsStepsAndHowMany) {
    FourDrags drags;
    EXPECT_EQ(drags.session.remark(), "");
    expect_done(drags.session, drags.history_limit_for(2));
    EXPECT_TRUE(contains(drags.session.remark(), "the 2 oldest steps can no longer be undone"))
        << drags.session.remark();
    expect_done(drags.session, command::Brush{.radius = 0.5});
    EXPECT_EQ(drags.session.remark(), "");
    expect_done(drags.session, megabytes(2e-6));
    EXPECT_TRUE(contains(drags.session.remark(),
                         "the oldest step can no longer be undone, since "
                         "undo may take at most 2e-06 MB"))
        << drags.session.remark();
    // A drag with the mouse reports it, too.
    const Vec3 from{0, 0, -1}, to{0, 0, -1.2};
    ASSERT_TRUE(drags.session.begin_drag(std::span(&from, 1), {}));
    ASSERT_TRUE(drags.session.drag_to(std::span(&to, 1)));
    drags.session.end_drag();
    EXPECT_TRUE(contains(drags.session.remark(), "the oldest step can no longer be undone"));
}

TEST(HistoryLimit, StaysWithANewObjectWhoseHistoryIsWhole) {
    FourDrags drags;
    expect_done(drags.session, megabytes(0.001));
    ASSERT_GT(drags.session.history().lost_undo_count(), 0u);
    expect_done(drags.session, Shape{Shape::Kind::cube, 2});
    EXPECT_EQ(drags.session.history().limit(), 1000u);
    EXPECT_EQ(drags.session.history().lost_undo_count(), 0u);
    EXPECT_EQ(drags.session.history().step_number(), 0u);
    EXPECT_EQ(drags.session.history().memory_bytes(), 0u);
    EXPECT_FALSE(contains(refusal_of(drags.session, Undo{}), "dropped"));
}

// The mesh is then the result of a step that was dropped.
TEST(HistoryLimit, RemembersWhereTheLastDroppedStepHadStoppedShort) {
    Session session;
    expect_done(session, Shape{Shape::Kind::sphere, 3});
    const std::uint32_t faces = session.mesh().face_count();
    expect_done(session, Adapt{.theta_max = Setting::of(1.0), .budget = faces + 400});
    expect_done(session, Drag{.moves = {{{0, 1, 0}, {0, 1.4, 0}}}});
    ASSERT_TRUE(session.statistics().budget_hit);
    expect_done(session, Drag{.moves = {{{0, -1, 0}, {0, -1.0001, 0}}}});
    expect_done(session, megabytes(1e-6));
    ASSERT_EQ(session.undo_count(), 1u);
    expect_done(session, Undo{});
    EXPECT_TRUE(session.statistics().budget_hit);
    EXPECT_EQ(session.statistics().needing_refinement, 0u);
    expect_done(session, Adapt{.budget = 1'000'000});
    EXPECT_FALSE(session.statistics().budget_hit);
    expect_done(session, Redo{});
    expect_done(session, Undo{});
    EXPECT_FALSE(session.statistics().budget_hit) << "other settings forget it for good";
}

TEST(HistoryLimit, RefusesInvalidAmountsOfMemory) {
    FourDrags drags;
    for (const Setting& wrong : {Setting::of(0.0), Setting::of(-1.0), Setting::of(kInfinity),
                                 Setting::of(kNotANumber), Setting::automatic()}) {
        EXPECT_TRUE(contains(refusal_of(drags.session, command::History{wrong}),
                             "must be a number above 0 or null"));
    }
    EXPECT_EQ(drags.session.history().limit(), History::kDefaultLimit);
    EXPECT_EQ(drags.session.history().undo_count(), 4u);
    // A limit beyond the range of integers means no limit.
    expect_done(drags.session, megabytes(1e300));
    EXPECT_FALSE(drags.session.history().limit());
}

// ---- What is counted

History::Step step_of(std::size_t faces) {
    History::Step step{.command = Drag{}, .change = {}, .outcome = {}};
    step.change.faces = std::vector<FaceId>(faces);
    return step;
}

TEST(HistoryMemory, CountsAllThatAStepOwns) {
    const std::size_t bare = step_of(0).memory_bytes();
    EXPECT_GE(bare, sizeof(History::Step));
    EXPECT_EQ(step_of(1000).memory_bytes(), bare + 4000);
    History::Step step = step_of(0);
    std::get<Drag>(step.command).via.assign(50, Vec3{0.0});
    std::get<Drag>(step.command).pins.assign(20, Vec3{0.0});
    EXPECT_GE(step.memory_bytes(), bare + 70 * sizeof(Vec3));
    step = step_of(0);
    step.command = command::Control{.points = std::vector<command::Control::Point>(30)};
    EXPECT_GE(step.memory_bytes(), bare + 30 * sizeof(command::Control::Point));
    step = step_of(0);
    step.exchanged = std::make_unique<TriMesh>(build_mesh(make_shape(ShapeKind::sphere, 3)).mesh);
    EXPECT_GE(step.memory_bytes(), bare + step.exchanged->memory_bytes());
}

TEST(HistoryMemory, IsTheSumOfItsStepsWhateverHappensToThem) {
    History history;
    EXPECT_EQ(history.memory_bytes(), 0u);
    std::size_t expected = 0;
    for (const std::size_t faces : {100u, 2000u, 30u}) {
        History::Step step = step_of(faces);
        expected += step.memory_bytes();
        history.add(std::move(step));
        EXPECT_EQ(history.memory_bytes(), expected);
    }
    // This includes the exchanged meshes of a bake, which may differ in size.
    history.undo(1, [](History::Step& step) { step.change.faces.resize(5000); });
    expected += sizeof(FaceId) * (5000 - 30);
    EXPECT_EQ(history.memory_bytes(), expected);
    history.redo(1, [](History::Step& step) {
        step.change.faces.resize(30);
        step.change.faces.shrink_to_fit();
    });
    expected -= sizeof(FaceId) * (5000 - 30);
    EXPECT_EQ(history.memory_bytes(), expected);
    history.undo(2, [](History::Step&) {});
    history.add(step_of(7));
    EXPECT_EQ(history.memory_bytes(), step_of(100).memory_bytes() + step_of(7).memory_bytes());
}

// The meshes that a bake exchanges may differ in size, so undoing a bake may take more memory.
TEST(HistoryMemory, MayExceedTheLimitWhileEverythingIsUndone) {
    History history;
    history.set_limit(3 * step_of(1000).memory_bytes());
    for (int i = 0; i < 4; ++i) history.add(step_of(1000));
    ASSERT_EQ(history.undo_count(), 3u);
    EXPECT_EQ(history.take_dropped_count(), 1u);
    EXPECT_EQ(history.take_dropped_count(), 0u);
    history.undo(3, [](History::Step& step) { step.change.faces = std::vector<FaceId>(1500); });
    EXPECT_EQ(history.redo_count(), 3u);
    history.redo(2, [](History::Step&) {});
    EXPECT_EQ(history.redo_count(), 1u) << "the newest step is not dropped";
    history.redo(1, [](History::Step&) {});
    EXPECT_LE(history.memory_bytes(), *history.limit());
    EXPECT_EQ(history.undo_count(), 2u);
    EXPECT_EQ(history.step_number(), 4u);
}

TEST(HistoryStates, HaveNumbersThatUndoAndRedoReturnToAndNewStepsDoNotReuse) {
    FourDrags drags;
    Session& session = drags.session;
    const History& history = session.history();
    std::vector<std::uint64_t> ids{history.state_id()};  // of the last state, then those before it
    for (int i = 0; i < 4; ++i) {
        expect_done(session, Undo{});
        ids.push_back(history.state_id());
    }
    EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), 5u);
    for (std::size_t i = 4; i-- > 0;) {
        expect_done(session, Redo{});
        EXPECT_EQ(history.state_id(), ids[i]);
    }
    expect_done(session, Undo{.count = 2});
    expect_done(session, Drag{.moves = {{{-1, 0, 0}, {-1.3, 0, 0}}}});
    ASSERT_EQ(history.step_number(), 3u);
    EXPECT_EQ(std::count(ids.begin(), ids.end(), history.state_id()), 0);
    // The limit drops all steps but the last, and the states stay what they are.
    const std::uint64_t last = history.state_id();
    expect_done(session, megabytes(1e-6));
    EXPECT_EQ(history.state_id(), last);
    expect_done(session, Undo{});
    EXPECT_EQ(history.state_id(), ids[2]);
    // Another object.
    ids.push_back(last);
    expect_done(session, Shape{Shape::Kind::sphere, 3});
    EXPECT_EQ(std::count(ids.begin(), ids.end(), history.state_id()), 0);
}

TEST(HistoryMemory, IsPartOfTheStatistics) {
    FourDrags drags;
    expect_done(drags.session, Undo{});
    const Statistics statistics = drags.session.statistics();
    EXPECT_EQ(statistics.undo_steps, 3u);
    EXPECT_EQ(statistics.undo_bytes, drags.bytes[3]);
    EXPECT_GT(statistics.memory_bytes, statistics.undo_bytes + 100 * statistics.vertices);
    EXPECT_TRUE(contains(format_statistics(statistics), "\"undo_steps\": 3,\n  \"undo_bytes\": " +
                                                            std::to_string(drags.bytes[3]) + "\n"));
}

}  // namespace
}  // namespace pectin

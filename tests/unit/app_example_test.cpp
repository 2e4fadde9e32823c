// The examples of the menu Help: what their scripts do, and how they are played.
#include "app/example_player.h"

#include <algorithm>
#include <fstream>

#include "io/file_error.h"
#include "io/obj_writer.h"
#include "support/offscreen_window.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

using namespace std::chrono_literals;
using Clock = ExamplePlayer::Clock;

constexpr std::array kExamples{Example::nose, Example::elephant, Example::cage};

std::vector<ExampleStep> script(Example example) {
    return read_example(example, example_folders());
}

// The object that a replay of the script gives.
std::string replayed_object(Example example) {
    Session session;
    for (const ExampleStep& step : script(example)) {
        for (const Command& command : step.commands) {
            const Done done = session.execute(command);
            EXPECT_TRUE(done) << name(command) << ": " << done.refusal().reason;
        }
    }
    EXPECT_EQ(session.folded_vertices(), 0u);
    EXPECT_EQ(session.mesh().validate(), std::vector<std::string>{});
    return format_obj(session.mesh());
}

// --- Scripts.

TEST(Examples, HaveACaptionAtEachStepAndAreExecutedWithoutARefusal) {
    for (const Example example : kExamples) {
        SCOPED_TRACE(title_of(example));
        const std::vector<ExampleStep> steps = script(example);
        EXPECT_GE(steps.size(), 5u);
        for (const ExampleStep& step : steps) {
            EXPECT_GT(step.caption.size(), 5u);
            EXPECT_TRUE(step.caption.ends_with('.')) << step.caption;
            EXPECT_FALSE(step.commands.empty()) << step.caption;
        }
        EXPECT_TRUE(std::holds_alternative<command::Shape>(steps.front().commands.front()));
        EXPECT_FALSE(replayed_object(example).empty());
    }
}

TEST(Examples, AreFoundBesideTheInstalledProgramFirst) {
    const ScratchFolder folder;
    folder.write("nose.jsonl",
                 "{\"pectin\": 1}\n# Only a plane.\n"
                 "{\"cmd\": \"shape\", \"kind\": \"plane\", \"resolution\": 2}\n"
                 "{\"cmd\": \"save\", \"path\": \"no.obj\"}\n");
    std::vector<std::filesystem::path> folders = example_folders();
    ASSERT_EQ(folders.size(), 2u);
    EXPECT_EQ(folders.front().filename(), "examples");
    folders.front() = folder.path();
    const std::vector<ExampleStep> steps = read_example(Example::nose, folders);
    ASSERT_EQ(steps.size(), 1u);
    EXPECT_EQ(steps.front().caption, "Only a plane.");
    EXPECT_EQ(steps.front().commands.size(), 1u) << "an example writes no files";
    EXPECT_GT(read_example(Example::cage, folders).size(), 1u) << "from the second folder";
}

TEST(Examples, ThatAreMissingOrWrongAreRefused) {
    const ScratchFolder folder;
    EXPECT_THROW(read_example(Example::nose, {folder.path()}), FileError);
    folder.write("nose.jsonl", "{\"pectin\": 1}\n{\"cmd\": \"shap\"}\n");
    EXPECT_THROW(read_example(Example::nose, {folder.path()}), FileError);
}

// --- Playing, with a clock of its own.

class ExamplePlayerTest : public EditorTest {
  protected:
    // Lets time pass until the present step has been shown.
    void run_step() {
        do {
            now_ += 16ms;
            player_.advance(now_);
        } while (player_.is_moving());
    }
    void begin(const std::vector<std::string>& lines) {
        std::string text = "{\"pectin\": 1}\n";
        for (const std::string& line : lines) text += line + "\n";
        write("own.jsonl", text);
        player_.begin("own", read_example(path("own.jsonl")));
    }
    void begin_two_drags() {
        begin({"# A ball.", R"({"cmd": "shape", "kind": "sphere", "resolution": 3})",
               R"({"cmd": "brush", "radius": 0.8})", "# Two drags.",
               R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0, 0, 1.5]}]})",
               R"({"cmd": "drag", "moves": [{"from": [1, 0, 0], "to": [1.4, 0, 0]}]})", "# End.",
               R"({"cmd": "brush", "radius": 0.5})"});
    }
    std::string object() const { return format_obj(editor_.session().mesh()); }

    PreparedEditor editor_ = editor();
    ExamplePlayer player_{editor_, [this](const Command& command) {
                              const bool is_done = editor_.execute(command);
                              if (is_done) player_.command_done(command);
                              return is_done;
                          }};
    Clock::time_point now_ = Clock::now();
};

TEST_F(ExamplePlayerTest, DragsAreMotionsThatEndAsTheScriptSays) {
    begin_two_drags();
    EXPECT_EQ(player_.caption(), "A ball.");
    EXPECT_FALSE(player_.needs_frame(now_));
    const std::string ball = object();
    player_.next();
    EXPECT_EQ(player_.caption(), "Two drags.");
    int frames = 0;
    double highest = 1.0;
    do {
        now_ += 16ms;
        player_.advance(now_);
        ++frames;
        const double top = editor_.session().mesh().bounding_box().max.z;
        EXPECT_GE(top, highest - 1e-9) << "frame " << frames;
        EXPECT_LT(top, 1.51);
        highest = top;
    } while (player_.is_moving());
    EXPECT_GT(frames, 60);
    EXPECT_FALSE(editor_.session().is_dragging());
    EXPECT_EQ(editor_.session().undo_count(), 2u);
    EXPECT_DOUBLE_EQ(editor_.session().mesh().bounding_box().max.z, 1.5);
    EXPECT_DOUBLE_EQ(editor_.session().mesh().bounding_box().max.x, 1.4);
    for (int i = 0; i < 2; ++i) editor_.undo();
    EXPECT_TRUE(object() == ball);
}

TEST_F(ExamplePlayerTest, ASecondNextEndsAStepAtOnce) {
    begin_two_drags();
    player_.next();
    player_.advance(now_);
    EXPECT_TRUE(player_.is_moving());
    player_.next();
    player_.advance(now_);
    EXPECT_FALSE(player_.is_moving());
    EXPECT_EQ(editor_.session().undo_count(), 2u);
    EXPECT_EQ(player_.step(), 1u);
}

TEST_F(ExamplePlayerTest, StoppingLeavesTheObjectAsItIs) {
    begin_two_drags();
    player_.next();
    for (int i = 0; i < 30; ++i) player_.advance(now_ += 16ms);
    ASSERT_TRUE(player_.is_moving());
    const double half = editor_.session().mesh().bounding_box().max.z;
    EXPECT_GT(half, 1.05);
    EXPECT_LT(half, 1.45);
    player_.stop();
    EXPECT_FALSE(player_.is_open());
    EXPECT_FALSE(editor_.session().is_dragging());
    EXPECT_DOUBLE_EQ(editor_.session().mesh().bounding_box().max.z, half);
    EXPECT_EQ(editor_.session().undo_count(), 1u);
}

TEST_F(ExamplePlayerTest, PlayingShowsAllStepsWithTimeToRead) {
    begin_two_drags();
    player_.play();
    const Clock::time_point begin = now_;
    while (!player_.is_at_end()) player_.advance(now_ += 16ms);
    EXPECT_FALSE(player_.plays());
    EXPECT_EQ(editor_.session().undo_count(), 2u);
    EXPECT_GT(now_ - begin, 2s);
    EXPECT_LT(now_ - begin, 6s);
    EXPECT_FALSE(player_.needs_frame(now_));
}

TEST_F(ExamplePlayerTest, EachExampleTakesAboutAMinuteAndGivesTheObjectOfItsReplay) {
    for (const Example example : kExamples) {
        SCOPED_TRACE(title_of(example));
        const Clock::time_point begin = now_;
        player_.begin("", script(example));
        player_.play();
        while (!player_.is_at_end()) {
            now_ += 50ms;
            player_.advance(now_);
            ASSERT_LT(now_ - begin, 100s);
        }
        EXPECT_GT(now_ - begin, 20s);
        EXPECT_TRUE(object() == replayed_object(example));
        EXPECT_EQ(editor_.workspace().message(), "");
        player_.stop();
    }
}

TEST_F(ExamplePlayerTest, SettingsOfTheUserDoNotChangeTheObject) {
    editor_.execute(command::Adapt{.theta_max = Setting::of(3.0)});
    editor_.execute(command::Symmetry{.plane = command::Symmetry::Plane::y});
    editor_.execute(command::Brush{.span = 7});
    player_.begin("", script(Example::cage));
    while (!player_.is_at_end()) {
        player_.next();
        player_.next();
        player_.advance(now_);
    }
    EXPECT_TRUE(object() == replayed_object(Example::cage));
}

TEST_F(ExamplePlayerTest, ACommandThatIsRefusedStopsWithItsMessage) {
    begin({"# A ball.", R"({"cmd": "shape", "kind": "sphere", "resolution": 3})", "# No.",
           R"({"cmd": "control", "points": [{"index": [0, 0, 0], "to": [0, 0, 0]}]})", "# End.",
           R"({"cmd": "brush", "radius": 0.5})"});
    player_.play();
    for (int i = 0; i < 400; ++i) player_.advance(now_ += 16ms);
    EXPECT_FALSE(player_.plays());
    EXPECT_EQ(player_.step(), 1u);
    EXPECT_NE(editor_.workspace().message(), "");
}

// --- In the window.

class ExampleInWindow : public testing::Test {
  protected:
    void run_step() {
        editor_.example().next();
        editor_.example().next();
        window_.frame();
    }
    test::OffscreenWindow window_;
    Editor& editor_ = window_.editor();
};

TEST_F(ExampleInWindow, ButtonsGoOnAndEscLeavesTheObject) {
    editor_.perform(Action::example_nose);
    window_.settle();
    ASSERT_TRUE(editor_.example().is_open());
    EXPECT_TRUE(window_.find("A nose"));
    ASSERT_TRUE(window_.click("Next"));
    EXPECT_EQ(editor_.example().step(), 1u);
    ASSERT_TRUE(window_.click("Next"));
    EXPECT_FALSE(editor_.example().is_moving());
    const std::size_t steps = editor_.session().undo_count();
    EXPECT_GT(steps, 0u);
    ASSERT_TRUE(window_.click("Play"));
    EXPECT_TRUE(editor_.example().plays());
    ASSERT_TRUE(window_.click("Pause"));
    EXPECT_FALSE(editor_.example().plays());
    window_.key(Key::escape);
    EXPECT_FALSE(editor_.example().is_open());
    EXPECT_GE(editor_.session().undo_count(), steps);
}

TEST_F(ExampleInWindow, TheViewCanBeTurnedWhileADragIsShown) {
    editor_.perform(Action::example_nose);
    editor_.example().next();
    window_.frame();
    ASSERT_TRUE(editor_.example().is_moving());
    const Camera before = editor_.camera();
    window_.pull({640, 300}, {700, 320});
    EXPECT_NE(editor_.camera(), before);
    EXPECT_TRUE(editor_.example().is_moving());
    window_.release({700, 320});
}

TEST_F(ExampleInWindow, UnsavedChangesAreAskedAboutFirst) {
    window_.drag({640, 330}, {700, 260});
    ASSERT_TRUE(editor_.workspace().is_modified());
    editor_.perform(Action::example_cage);
    EXPECT_TRUE(editor_.document().question());
    EXPECT_FALSE(editor_.example().is_open());
    editor_.document().answer(DocumentController::Answer::cancel);
    EXPECT_FALSE(editor_.example().is_open());
    editor_.perform(Action::example_cage);
    editor_.document().answer(DocumentController::Answer::discard);
    EXPECT_TRUE(editor_.example().is_open());
    EXPECT_EQ(editor_.session().undo_count(), 0u);
}

TEST_F(ExampleInWindow, AnotherObjectEndsIt) {
    editor_.perform(Action::example_elephant);
    ASSERT_TRUE(editor_.example().is_open());
    editor_.perform(Action::new_cube);
    EXPECT_FALSE(editor_.example().is_open());
}

TEST_F(ExampleInWindow, AnActionOfTheUserEndsAMotionWhereItIs) {
    editor_.perform(Action::example_nose);
    editor_.example().next();
    window_.frame();
    ASSERT_TRUE(editor_.example().is_moving());
    window_.key(Key{'W'});
    EXPECT_TRUE(editor_.display.wireframe);
    EXPECT_FALSE(editor_.example().is_moving());
    EXPECT_TRUE(editor_.example().is_open());
}

TEST_F(ExampleInWindow, TheCaptionsTakeTheSameSpaceAtEveryStep) {
    for (const IVec2& size : {IVec2{1280, 720}, IVec2{800, 600}}) {
        window_.resize(size);
        editor_.perform(Action::example_elephant);
        window_.settle();
        const auto free = window_.interface().free_area();
        EXPECT_LT(free.max.y, size.y - 80.0) << "framing leaves the captions free";
        while (!editor_.example().is_at_end()) {
            run_step();
            window_.settle();
            EXPECT_EQ(window_.interface().free_area().max, free.max);
            const auto button = window_.find("Next");
            ASSERT_TRUE(button);
            EXPECT_TRUE(button->x > free.min.x && button->x < free.max.x) << "over a panel";
            const std::string caption = editor_.example().caption();
            EXPECT_TRUE(window_.find(caption.substr(caption.rfind(' ') + 1))) << "is cut off";
        }
        window_.key(Key::escape);
        editor_.document().new_shape(command::Shape::Kind::sphere, 3);
        editor_.document().answer(DocumentController::Answer::discard);
    }
}

TEST_F(ExampleInWindow, AllThatIsDraggedStaysInTheWindow) {
    for (const Action action :
         {Action::example_nose, Action::example_elephant, Action::example_cage}) {
        SCOPED_TRACE(info_of(action).name);
        editor_.perform(action);
        window_.settle();
        const Camera camera = editor_.camera();
        const auto free = window_.interface().free_area();
        while (!editor_.example().is_at_end()) run_step();
        EXPECT_EQ(editor_.camera(), camera) << "the view was changed in between";
        const TriMesh& mesh = editor_.session().mesh();
        for (std::uint32_t i = 0; i < mesh.vertex_slots(); i += 7) {
            if (!exists(mesh.half_edge(VertexId{i}))) continue;
            const auto at = camera.project(mesh.position(VertexId{i}), window_.size());
            ASSERT_TRUE(at);
            EXPECT_TRUE(glm::all(glm::greaterThan(*at, free.min)) &&
                        glm::all(glm::lessThan(*at, free.max)))
                << "covered by a panel or by the captions";
        }
        editor_.example().stop();
        editor_.document().new_shape(command::Shape::Kind::sphere, 3);
        editor_.document().answer(DocumentController::Answer::discard);
    }
}

}  // namespace
}  // namespace pectin

// Tests the real window on a virtual display with mouse and keyboard.
#include <gtest/gtest.h>

#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "replay/program.h"
#include "window/desktop.h"

namespace pectin {
namespace {

using namespace std::chrono_literals;

constexpr int kMiddleX = 640, kMiddleY = 400;

class WindowTest : public testing::Test {
  protected:
    void SetUp() override {
        if (const std::string missing = missing_for_windows(); !missing.empty()) {
            GTEST_SKIP() << "the window cannot be tested here: " << missing;
        }
        desktop_ = std::make_unique<Desktop>();
        ASSERT_TRUE(desktop_->is_running()) << "Xvfb does not start";
    }
    void TearDown() override {
        const bool has_words = folder_.holds("err") && !folder_.read("err").empty();
        if (HasFailure() && has_words) std::cerr << "pectin said: " << folder_.read("err");
    }

    void open_window(const std::vector<std::string>& arguments = {}) {
        std::filesystem::remove(path("record.jsonl"));
        open_window_beside_record(arguments);
    }
    void open_window_beside_record(std::vector<std::string> arguments = {}) {
        arguments.insert(arguments.begin(), {PECTIN_BINARY, "--record", path("record.jsonl")});
        Environment environment = desktop_->environment();
        environment.emplace_back("XDG_STATE_HOME", path("state"));
        start(arguments, environment);
    }
    void start(const std::vector<std::string>& words, const Environment& environment) {
        program_ = std::make_unique<Process>(words, environment, path("err"));
        ASSERT_TRUE(desktop_->shows_window());
        ASSERT_TRUE(eventually([&] { return recorded("\"shape\"") + recorded("\"open\"") > 0; }));
        desktop_->move(kMiddleX, kMiddleY);
    }
    // Saves through the file browser by typing the path.
    void save_as(const std::string& name) {
        desktop_->key("ctrl+shift+s");
        desktop_->type(path(name));
        desktop_->key("Return");
        ASSERT_TRUE(eventually([&] { return folder_.holds(name); })) << record();
        ASSERT_TRUE(records(name));
    }
    void quit() {
        desktop_->key("ctrl+q");
        ASSERT_EQ(program_->wait(), 0);
    }
    // Waits until the program has handled all earlier input.
    void wait_until_handled() {
        desktop_->move(kMiddleX, kMiddleY);
        const std::size_t before = recorded("\"brush\"");
        desktop_->key("bracketleft");
        ASSERT_TRUE(records("\"brush\"", before + 1)) << record();
    }
    // The file that the replay of the record saves instead of the window's last save.
    std::string replayed() const {
        std::string script = record();
        const std::size_t line = script.rfind("{\"cmd\": \"save\"");
        const std::size_t begin = script.find("\"path\": ", line), end = script.find('}', begin);
        script.replace(begin, end - begin, "\"path\": \"replayed.obj\"");
        folder_.write("replay.jsonl", script);
        const Outcome outcome = run_program({"replay", path("replay.jsonl")});
        EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
        return folder_.read("replayed.obj");
    }

    std::string path(const std::string& name) const { return folder_.path(name); }
    std::string record() const { return folder_.read("record.jsonl"); }
    std::size_t recorded(const std::string& what) const {
        const std::string text = folder_.holds("record.jsonl") ? record() : "";
        std::size_t count = 0;
        for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; ++at) ++count;
        return count;
    }
    bool records(const std::string& what, std::size_t times = 1) const {
        return eventually([&] { return recorded(what) >= times; });
    }
    Process& program() { return *program_; }
    const Desktop& desktop() const { return *desktop_; }
    const ScratchFolder& folder() const { return folder_; }
    // The number of files that are kept for recovery.
    std::size_t recovery_files() const {
        const std::set<std::string> files = folder_.files();
        return static_cast<std::size_t>(std::count_if(
            files.begin(), files.end(),
            [](const std::string& name) { return name.starts_with("state/pectin/"); }));
    }

  private:
    ScratchFolder folder_;
    std::unique_ptr<Desktop> desktop_;
    std::unique_ptr<Process> program_;
};

TEST_F(WindowTest, RecordsAScriptWhoseReplaySavesTheSameBytes) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\"", 1));
    desktop().key("bracketleft");
    ASSERT_TRUE(records("\"brush\""));
    desktop().drag(560, 420, 520, 470);
    ASSERT_TRUE(records("\"drag\"", 2));
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(WindowTest, RecordsPinsSymmetryAndTheWheelSoThatReplaySavesTheSameBytes) {
    open_window();
    ASSERT_TRUE(records("\"symmetry\"")) << "the first sphere is symmetric";
    desktop().move(700, 470);
    desktop().key("p");
    desktop().move(kMiddleX, kMiddleY);
    desktop().press();
    desktop().move(680, 360);
    desktop().move(720, 330);
    desktop().press(4);
    desktop().release(4);
    desktop().hold("shift");
    desktop().press(4);
    desktop().release(4);
    desktop().release_key("shift");
    desktop().release();
    ASSERT_TRUE(records("\"drag\""));
    EXPECT_EQ(recorded("\"pins\": [["), 1u) << record();
    EXPECT_EQ(recorded("\"degrees\": 5"), 1u) << record();
    EXPECT_EQ(recorded("\"scale\": 1.05"), 1u) << record();
    EXPECT_EQ(recorded("\"connected\": true, \"fold_free\": true"), 1u) << record();
    desktop().key("x");
    ASSERT_TRUE(records("\"symmetry\"", 2));
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(WindowTest, RestoresTheSphereOnEscapeDuringADrag) {
    open_window();
    save_as("before.obj");
    desktop().move(kMiddleX, kMiddleY);
    desktop().press();
    desktop().move(700, 330);
    desktop().move(760, 290);
    desktop().key("Escape");
    desktop().release();
    save_as("after.obj");
    quit();
    EXPECT_EQ(recorded("\"drag\""), 0u);
    EXPECT_TRUE(folder().read("after.obj") == folder().read("before.obj"));
}

TEST_F(WindowTest, UndoesAndRedoesADragToTheByteByKeys) {
    open_window();
    save_as("sphere.obj");
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    save_as("dragged.obj");
    desktop().key("ctrl+z");
    ASSERT_TRUE(records("\"undo\""));
    save_as("undone.obj");
    desktop().key("ctrl+shift+z");
    ASSERT_TRUE(records("\"redo\""));
    save_as("redone.obj");
    quit();
    EXPECT_TRUE(folder().read("dragged.obj") != folder().read("sphere.obj"));
    EXPECT_TRUE(folder().read("undone.obj") == folder().read("sphere.obj"));
    EXPECT_TRUE(folder().read("redone.obj") == folder().read("dragged.obj"));
    EXPECT_TRUE(folder().read("redone.obj") == replayed());
}

TEST_F(WindowTest, DragsAlongTheNormalWithAlt) {
    open_window();
    desktop().key("KP_1");
    desktop().move(kMiddleX, kMiddleY);
    desktop().press();
    desktop().hold("alt");
    desktop().move(kMiddleX, kMiddleY - 30);
    desktop().move(kMiddleX, kMiddleY - 60);
    desktop().release();
    desktop().release_key("alt");
    ASSERT_TRUE(records("\"drag\""));
    // In the front view, the foremost point of the sphere moves along z and keeps x and y.
    const std::string text = record();
    const std::string to = text.substr(text.find("\"to\": ["));
    double x = 1, y = 1, z = 0;
    ASSERT_EQ(std::sscanf(to.c_str(), "\"to\": [%lf, %lf, %lf]", &x, &y, &z), 3) << to;
    EXPECT_NEAR(x, 0.0, 0.03);
    EXPECT_NEAR(y, 0.0, 0.03);
    EXPECT_GT(z, 1.1);
}

// Drags on every row of the panel from top to bottom, so that the position of the slider need not
// be known.
TEST_F(WindowTest, ReadaptsTheObjectWhenASliderIsReleased) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    for (int y = 145; y < 260 && recorded("\"theta_max\"") == 0; y += 10) {
        desktop().move(1110, y);
        desktop().press();
        desktop().move(1085, y);
        desktop().release();
        wait_until_handled();
    }
    ASSERT_EQ(recorded("\"theta_max\""), 1u);
    EXPECT_EQ(recorded("\"theta_max\": null"), 0u) << "its toggle, not the slider";
    ASSERT_TRUE(records("\"readapt\""));
    desktop().move(kMiddleX, kMiddleY);
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

TEST_F(WindowTest, OpensAModelFromTheFileBrowser) {
    folder().write("models/wedge.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    open_window();
    desktop().key("ctrl+o");
    desktop().type(path("models"));  // a folder, which the browser enters
    desktop().key("Return");
    desktop().type("wedge.obj");
    desktop().key("Return");
    ASSERT_TRUE(records("\"open\"")) << record();
    EXPECT_EQ(recorded("wedge.obj"), 1u);
    save_as("window.obj");
    quit();
    EXPECT_TRUE(folder().read("window.obj") == replayed());
}

// All keys are typed while the program is busy, before the next frame.
TEST_F(WindowTest, LosesNoKeyTypedDuringASlowFrame) {
    open_window();
    program().pause();
    desktop().key("ctrl+shift+s");
    desktop().type(path("first.obj"));
    desktop().key("Return");
    desktop().key("x");
    desktop().drag(kMiddleX, kMiddleY, 700, 350);
    desktop().key("ctrl+shift+s");
    desktop().type(path("second.obj"));
    desktop().key("Return");
    program().resume();
    ASSERT_TRUE(records("second.obj")) << record();
    EXPECT_EQ(recorded("first.obj"), 1u);
    EXPECT_EQ(recorded("\"drag\""), 1u);
    EXPECT_EQ(recorded("\"symmetry\""), 2u);
    quit();
    EXPECT_TRUE(folder().read("second.obj") != folder().read("first.obj"));
    EXPECT_TRUE(folder().read("second.obj") == replayed());
}

TEST_F(WindowTest, OpensDroppedModelsAndKeepsTheObjectForOtherFiles) {
    folder().write("a wedge.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    folder().write("letter.obj", "Dear tetrahedron\n");
    open_window();
    ASSERT_TRUE(desktop().drop(path("a wedge.obj")));
    ASSERT_TRUE(records("\"open\""));
    EXPECT_EQ(recorded("a wedge.obj"), 1u);
    ASSERT_TRUE(desktop().drop(path("letter.obj")));
    save_as("window.obj");
    quit();
    EXPECT_EQ(recorded("letter.obj"), 0u);
    EXPECT_TRUE(folder().read("window.obj") == replayed());
    EXPECT_NE(folder().read("window.obj").find("v 0 0 1"), std::string::npos);
}

// Escape cancels the reading of a file and keeps the object.
TEST_F(WindowTest, OpensALargeFileInTheBackgroundAndCanCancelIt) {
    // With sanitizers a quarter of the size takes as long.
    const int resolution = std::getenv("PECTIN_TEST_SANITIZED") ? 7 : 8;
    const std::string script = folder().write_script(
        "large.jsonl",
        {R"({"cmd": "shape", "kind": "sphere", "resolution": )" + std::to_string(resolution) + "}",
         R"({"cmd": "save", "path": "large.obj"})"});
    ASSERT_EQ(run_program({"replay", script}).exit_status, 0);
    // The model is open if saving it again gives the same bytes.
    const auto expect_open = [&](const std::string& name, std::size_t saves) {
        const std::string before = folder().read(name);
        std::filesystem::remove(path(name));
        desktop().key("ctrl+s");
        ASSERT_TRUE(records("\"save\"", saves)) << record();
        EXPECT_TRUE(folder().read(name) == before);
    };
    open_window();
    save_as("ball.obj");
    ASSERT_TRUE(desktop().drop(path("large.obj")));
    desktop().key("Escape");
    // The dialog receives all keys until it is closed.
    ASSERT_TRUE(eventually([&] {
        desktop().key("bracketleft");
        return recorded("\"brush\"") > 0;
    }));
    expect_open("ball.obj", 2);
    EXPECT_EQ(recorded("\"open\""), 0u);

    ASSERT_TRUE(desktop().drop(path("large.obj")));
    ASSERT_TRUE(eventually([&] { return recorded("\"open\"") == 1; }));
    expect_open("large.obj", 3);
    quit();
}

TEST_F(WindowTest, OpensTheModelOfTheCommandLineOrASphereIfItFails) {
    folder().write("wedge.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    open_window({path("wedge.obj")});
    EXPECT_EQ(recorded("\"shape\""), 0u);
    quit();
    folder().write("letter.obj", "Dear sphere\n");
    open_window({path("letter.obj")});
    EXPECT_EQ(recorded("\"open\""), 0u);
    EXPECT_EQ(recorded("\"shape\""), 1u);
    quit();
}

TEST_F(WindowTest, AsksAndSavesWhenQuittingWithChanges) {
    open_window();
    save_as("ball.obj");
    const std::string before = folder().read("ball.obj");
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    desktop().key("ctrl+q");
    ASSERT_TRUE(eventually([&] {
        desktop().key("Return");  // the first button: save
        return recorded("\"save\"") == 2;
    }));
    const std::string after = folder().read("ball.obj");
    EXPECT_TRUE(after != before);
    EXPECT_TRUE(after == replayed());
}

TEST_F(WindowTest, OffersTheSessionAfterACrashAndRestoresItToTheByte) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    save_as("saved.obj");
    desktop().drag(560, 420, 520, 470);
    ASSERT_TRUE(records("\"drag\"", 2));
    const std::string crashed = record();
    program().signal(SIGKILL);
    ASSERT_EQ(program().wait(), -1);
    EXPECT_EQ(recovery_files(), 1u);
    const std::string saved = folder().read("saved.obj");

    open_window();
    desktop().key("Return");  // Restore
    ASSERT_TRUE(records("\"drag\"", 2)) << record();
    EXPECT_TRUE(folder().read("saved.obj") == saved) << "restoring writes no file";
    save_as("restored.obj");
    quit();
    EXPECT_EQ(recovery_files(), 0u);
    const std::string restored = folder().read("restored.obj");
    folder().write("record.jsonl", crashed + "{\"cmd\": \"save\", \"path\": \"at the end\"}\n");
    EXPECT_TRUE(restored == replayed());
}

TEST_F(WindowTest, EndsOnASignalAndKeepsTheSession) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    program().signal(SIGTERM);
    EXPECT_EQ(program().wait(), 143);
    EXPECT_NE(folder().read("err").find("ended by SIGTERM"), std::string::npos);
    EXPECT_EQ(recovery_files(), 1u);
    // With "not now" it is offered again the next time.
    open_window();
    desktop().key("Escape");
    wait_until_handled();
    quit();
    EXPECT_EQ(recovery_files(), 1u);
}

TEST_F(WindowTest, DoesNotOfferASessionWithoutUnsavedChanges) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    save_as("saved.obj");
    program().signal(SIGKILL);
    program().wait();
    open_window();
    wait_until_handled();
    quit();
    EXPECT_EQ(recovery_files(), 0u);
}

// The drags before the save are in the saved file, too.
TEST_F(WindowTest, RestoresASessionThatHasSavedOverItsModelToTheByte) {
    folder().write("wedge.obj",
                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const std::string opened = folder().read("wedge.obj");
    open_window({path("wedge.obj")});
    desktop().drag(kMiddleX, kMiddleY, 700, 360);
    ASSERT_TRUE(records("\"drag\"", 1)) << record();
    desktop().key("ctrl+s");
    ASSERT_TRUE(records("\"save\"")) << record();
    desktop().drag(kMiddleX, kMiddleY, 610, 350);
    ASSERT_TRUE(records("\"drag\"", 2)) << record();
    const std::string crashed = record();
    program().signal(SIGKILL);
    ASSERT_EQ(program().wait(), -1);
    const std::string saved = folder().read("wedge.obj");
    ASSERT_NE(saved, opened);

    open_window();
    desktop().key("Return");  // Restore
    ASSERT_TRUE(records("\"drag\"", 2)) << record();
    EXPECT_EQ(folder().read("wedge.obj"), saved) << "restoring writes no file";
    desktop().key("ctrl+s");
    ASSERT_TRUE(records("\"save\"")) << record();
    quit();
    EXPECT_EQ(recovery_files(), 0u);
    const std::string restored = folder().read("wedge.obj");
    folder().write("wedge.obj", opened);
    folder().write("record.jsonl", crashed + "{\"cmd\": \"save\", \"path\": \"at the end\"}\n");
    // The replay also saves over the model after it has opened it.
    EXPECT_TRUE(restored == replayed());
}

// Otherwise messages at the start would be written to the first file that is opened.
TEST_F(WindowTest, WritesNoMessagesIntoTheRecordIfTheErrorOutputIsClosed) {
    folder().write("record.jsonl", "{\"pectin\": 1}\n{\"cmd\": \"shape\"}\n");
    Environment environment = desktop().environment();
    environment.emplace_back("XDG_STATE_HOME", path("state"));
    start(
        {"/bin/sh", "-c", "exec \"$0\" --record \"$1\" 2>&-", PECTIN_BINARY, path("record.jsonl")},
        environment);
    ASSERT_TRUE(eventually([&] {
        return folder().holds("record-2.jsonl") &&
               folder().read("record-2.jsonl").find("\"symmetry\"") != std::string::npos;
    }));
    program().signal(SIGTERM);
    EXPECT_EQ(program().wait(), 143);
    const std::string text = folder().read("record-2.jsonl");
    EXPECT_EQ(text.rfind("{\"pectin\": 1}\n{\"cmd\": \"shape\"", 0), 0u) << text;
    EXPECT_EQ(text.find("earlier record"), std::string::npos) << text;
}

TEST_F(WindowTest, DoesNotPromiseRecoveryIfTheStateFolderCannotBeWritten) {
    folder().write("state", "a file in place of the folder");
    open_window();
    wait_until_handled();
    program().signal(SIGTERM);
    EXPECT_EQ(program().wait(), 143);
    EXPECT_EQ(folder().read("err"), "pectin: ended by SIGTERM\n");
}

// Tests the message and the exit status if no window can be opened.
Outcome open_without(const Environment& environment) {
    const ScratchFolder folder;
    Process program({PECTIN_BINARY}, environment, folder.path("err"));
    const auto status = program.wait();
    return {.exit_status = status.value_or(-2), .out = "", .err = folder.read("err")};
}

TEST(NoWindow, WithoutADisplayIsExplainedInOneSentence) {
    const Outcome outcome = open_without({{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_TRUE(outcome.err.starts_with("pectin: there is no display")) << outcome.err;
    EXPECT_NE(outcome.err.find("pectin replay SCRIPT"), std::string::npos);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
}

TEST_F(WindowTest, SaysInOneSentenceWhatToInstallWithoutOpenGl33) {
    Environment old = desktop().environment();
    old.emplace_back("MESA_GL_VERSION_OVERRIDE", "2.1");
    const Outcome outcome = open_without(old);
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_NE(outcome.err.find("OpenGL 3.3"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("install"), std::string::npos) << outcome.err;
}

TEST_F(WindowTest, DoesNotOpenIfTheRecordCannotBeWritten) {
    Process program({PECTIN_BINARY, "--record", path("no/such/folder.jsonl")},
                    desktop().environment(), path("err"));
    EXPECT_EQ(program.wait(), 1);
    EXPECT_NE(folder().read("err").find("no/such/folder.jsonl: "), std::string::npos);
}

}  // namespace
}  // namespace pectin

// The start of the program if no window can be opened, or if its output is closed.
#include <gtest/gtest.h>

#include <signal.h>

#include <algorithm>
#include <string>

#include "support/paths.h"
#include "window/window_fixture.h"

namespace pectin {
namespace {

// Returns the exit status and the message of the program if no window can be opened.
Outcome open_without(const Environment& environment) {
    const ScratchFolder folder;
    Process program({test::program_path()}, environment, folder.path("err"));
    const auto status = program.wait();
    return {.exit_status = status.value_or(-2), .out = "", .err = folder.read("err")};
}

// The position of the slider is not known, so every row is pressed and dragged, from the top down.

// All of this is typed while the program is busy, before its next frame.

// Escape cancels the reading of a file and keeps the object.

// The saved file already contains the drags before the save.

// Without standard error, messages could be written into the first file that is opened.

TEST_F(WindowTest, NoMessagesAreWrittenIntoTheRecordIfStandardErrorIsClosed) {
    folder().write("record.jsonl", "{\"pectin\": 1}\n{\"cmd\": \"shape\"}\n");
    Environment environment = desktop().environment();
    environment.emplace_back("XDG_STATE_HOME", path("state"));
    start({"/bin/sh", "-c", "exec \"$0\" --record \"$1\" 2>&-", test::program_path(),
           path("record.jsonl")},
          environment);
    ASSERT_TRUE(eventually([&] {
        return folder().holds("record-2.jsonl") &&
               folder().read("record-2.jsonl").find("\"symmetry\"") != std::string::npos;
    }));
    program().signal(SIGTERM);
    EXPECT_EQ(program().wait(), 143);
    const std::string text = folder().read("record-2.jsonl");
    EXPECT_EQ(text.rfind("{\"pectin\": 1}\n{\"cmd\": \"symmetry\"", 0), 0u) << text;
    EXPECT_EQ(text.find("earlier record"), std::string::npos) << text;
}

TEST(NoWindow, WithoutADisplayOneSentenceSaysWhatToDo) {
    const Outcome outcome = open_without({{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_TRUE(outcome.err.starts_with("pectin: there is no display")) << outcome.err;
    EXPECT_NE(outcome.err.find("pectin replay SCRIPT"), std::string::npos);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
}

TEST_F(WindowTest, WithoutOpenGl33OneSentenceSaysWhatToInstall) {
    Environment old = desktop().environment();
    old.emplace_back("MESA_GL_VERSION_OVERRIDE", "2.1");
    const Outcome outcome = open_without(old);
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_NE(outcome.err.find("OpenGL 3.3"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("install"), std::string::npos) << outcome.err;
}

TEST_F(WindowTest, ARecordThatCannotBeWrittenOpensNoWindow) {
    Process program({test::program_path(), "--record", path("no/such/folder.jsonl")},
                    desktop().environment(), path("err"));
    EXPECT_EQ(program.wait(), 1);
    EXPECT_NE(folder().read("err").find("no/such/folder.jsonl: "), std::string::npos);
}

}  // namespace
}  // namespace pectin

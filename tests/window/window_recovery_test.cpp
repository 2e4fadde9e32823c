// Recovery of sessions of the real window after a crash or a signal.
#include <gtest/gtest.h>

#include <signal.h>

#include <string>

#include "window/window_fixture.h"

namespace pectin {
namespace {

TEST_F(WindowTest, ACrashedSessionIsOfferedAndRestoredExactly) {
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

TEST_F(WindowTest, ASignalEndsTheWindowAndKeepsTheSession) {
    open_window();
    desktop().drag(kMiddleX, kMiddleY, 760, 290);
    ASSERT_TRUE(records("\"drag\""));
    program().signal(SIGTERM);
    EXPECT_EQ(program().wait(), 143);
    EXPECT_NE(folder().read("err").find("ended by SIGTERM"), std::string::npos);
    EXPECT_EQ(recovery_files(), 1u);
    // Escape means later: the session is offered again at the next start.
    open_window();
    desktop().key("Escape");
    wait_until_handled();
    quit();
    EXPECT_EQ(recovery_files(), 1u);
}

TEST_F(WindowTest, ASessionWithoutUnsavedChangesIsNotOffered) {
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

TEST_F(WindowTest, ASessionThatHasSavedOverItsModelIsRestoredExactly) {
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

TEST_F(WindowTest, RecoveryIsNotPromisedIfTheStateFolderCannotBeWritten) {
    folder().write("state", "a file in place of the folder");
    open_window();
    wait_until_handled();
    program().signal(SIGTERM);
    EXPECT_EQ(program().wait(), 143);
    EXPECT_EQ(folder().read("err"), "pectin: ended by SIGTERM\n");
}

}  // namespace
}  // namespace pectin

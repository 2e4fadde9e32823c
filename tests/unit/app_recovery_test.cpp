// The files that a window leaves in the state folder, and what the next window finds there.
#include <sys/stat.h>

#include <atomic>
#include <thread>

#include "unit/app_recovery_fixture.h"

namespace pectin {
namespace {

TEST_F(RecoveryTest, FindsOnlySessionsWithUnsavedChanges) {
    EXPECT_TRUE(lost().empty()) << "no folder yet";
    lose({kSphere});                                       // no changes
    lose({kSphere, kDrag, command::Save{path("a.obj")}});  // all changes are saved
    lose({kSphere, kDrag, command::Save{path("b.obj")}, kDrag});
    const auto sessions = lost();
    ASSERT_EQ(sessions.size(), 1u);
    EXPECT_EQ(sessions[0].object, "b.obj");
    EXPECT_EQ(sessions[0].unsaved, 1u);
    EXPECT_EQ(sessions[0].commands.size(), 4u);
    EXPECT_EQ(file_count(), 1u) << "the others hold nothing to restore";
    remove_lost_session(sessions[0]);
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(RecoveryTest, LeavesTheFilesOfRunningWindowsAlone) {
    RecoveryFile running(folder());
    running.record(kSphere);
    running.record(kDrag);
    EXPECT_TRUE(lost().empty());
    EXPECT_TRUE(fs::exists(running.path()));
    running.remove();
    EXPECT_FALSE(fs::exists(running.path()));
}

TEST_F(RecoveryTest, ReadsAFileWhoseLastLineIsIncomplete) {
    lose({kSphere, kDrag, kDrag});
    const std::string file = lost().at(0).path;
    fs::resize_file(file, fs::file_size(file) - 20);
    const auto sessions = lost();
    ASSERT_EQ(sessions.size(), 1u);
    EXPECT_EQ(sessions[0].commands, (std::vector<Command>{kSphere, kDrag}));
}

TEST_F(RecoveryTest, LeavesOtherFilesOfTheFolderAlone) {
    fs::create_directory(folder());
    write("state/notes.txt", "mine");
    ::mkfifo(path("state/recovery-2-0.jsonl").c_str(), 0600);
    EXPECT_TRUE(lost().empty());
    EXPECT_EQ(read("state/notes.txt"), "mine");
    EXPECT_EQ(file_count(), 2u);
}

TEST_F(RecoveryTest, ADamagedFileIsSetAsideAndReported) {
    const std::string header = "{\"pectin\": 1}\n";
    const std::string shape = R"({"cmd": "shape", "kind": "sphere", "resolution": 3})"
                              "\n";
    const std::string drag = R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0, 0, 2]}]})"
                             "\n";
    fs::create_directory(folder());
    for (const std::string& damaged :
         {std::string("not a script"), std::string("{\"pectin\": 99}\n"),
          // Invalid lines in the middle, and a complete invalid line at the end.
          header + shape + "{\"cmd\": \"dra\n" + drag, header + shape + drag + "{\"cmd\": \"dra\n",
          header + shape + std::string(100, '\0') + "\n" + drag,
          // The incomplete last line is all that could have been restored.
          header + shape + drag.substr(0, 20)}) {
        write("state/recovery-1-0.jsonl", damaged);
        const LostSessions found = find_lost_sessions(folder());
        EXPECT_TRUE(found.sessions.empty()) << damaged;
        EXPECT_EQ(found.damaged,
                  std::vector<std::string>{path("state/recovery-1-0.jsonl.incomplete")});
        EXPECT_EQ(read("state/recovery-1-0.jsonl.incomplete"), damaged);
        EXPECT_TRUE(find_lost_sessions(folder()).damaged.empty()) << "each file is reported once";
    }
    for (const std::string& empty : {std::string(), header.substr(0, 5), header, header + shape}) {
        write("state/recovery-1-0.jsonl", empty);
        EXPECT_TRUE(find_lost_sessions(folder()).damaged.empty()) << empty;
        EXPECT_FALSE(fs::exists(path("state/recovery-1-0.jsonl"))) << empty;
    }
}

TEST_F(RecoveryTest, LaterKeepsAllSessionsAndDiscardRemovesOne) {
    lose({kSphere, kDrag});
    lose({kSphere, kDrag});
    auto editor = this->editor();
    editor.document().offer(lost());
    editor.document().answer_recovery(DocumentController::RecoveryAnswer::discard);
    EXPECT_TRUE(editor.document().offered_session()) << "the second one";
    EXPECT_EQ(file_count(), 1u);
    key(editor, Key::escape);
    EXPECT_FALSE(editor.document().offered_session());
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(RecoveryTest, AFolderThatCannotBeWrittenIsReportedAndTheWindowGoesOn) {
    write("state", "a file in place of the folder");
    auto editor = this->editor();
    editor.workspace().begin_recovery(folder());
    const std::string message = editor.workspace().message();
    EXPECT_TRUE(
        message.starts_with("This session cannot be restored after a crash, because the "
                            "folder for recovery files cannot be written: "))
        << message;
    EXPECT_TRUE(message.ends_with('.')) << message;
    EXPECT_EQ(message.find('/'), std::string::npos) << message;
    EXPECT_FALSE(editor.workspace().has_recovery());
    EXPECT_TRUE(editor.execute(command::Brush{.radius = 0.3}));
}

TEST_F(RecoveryTest, ASessionThatCanNoLongerBeKeptIsReportedAndIsNotTakenForACrash) {
    for (const bool has_full_disk : {true, false}) {
        auto editor = this->editor();
        editor.workspace().begin_recovery(folder());
        ASSERT_TRUE(editor.execute(kDrag));
        ASSERT_TRUE(editor.workspace().has_recovery());
        if (has_full_disk) {
            const auto file = *fs::directory_iterator(folder());
            const FileSizeLimit limit(file.file_size() + 10);
            ASSERT_TRUE(editor.execute(kDrag));
        } else {
            write("caf\xe9.obj", kTetrahedron);
            ASSERT_TRUE(editor.execute(command::Open{path("caf\xe9.obj")}));
        }
        EXPECT_FALSE(editor.workspace().has_recovery());
        ASSERT_TRUE(editor.execute(command::Brush{.radius = 0.3}));
        const std::string message = editor.workspace().message();
        EXPECT_EQ(message,
                  std::string("From now on, changes cannot be restored after a crash, because the "
                              "recovery file ") +
                      (has_full_disk ? "cannot be written any more: File too large."
                                     : "cannot hold this open command, because its path is not "
                                       "UTF-8."));
        EXPECT_TRUE(lost().empty())
            << "another window must not be offered the running window's session";
        EXPECT_EQ(file_count(), 1u);
        editor.workspace().end_recovery();
        EXPECT_EQ(file_count(), 0u);
    }
}

TEST_F(RecoveryTest, AFullDiskLeavesOnlyCompleteLines) {
    fs::path file;
    {
        RecoveryFile recovery(folder());
        recovery.record(kSphere);
        recovery.record(kDrag);
        file = recovery.path();
        const FileSizeLimit limit(fs::file_size(file) + 10);
        EXPECT_THROW(recovery.record(kDrag), FileError);
    }
    EXPECT_TRUE(read("state/" + file.filename().string()).ends_with("}\n"));
    EXPECT_EQ(lost().at(0).commands, (std::vector<Command>{kSphere, kDrag}));
}

// A window looks for files without a lock while another window creates its own file.
TEST_F(RecoveryTest, WindowsThatStartTogetherKeepTheirFiles) {
    fs::create_directory(folder());
    std::atomic<bool> is_over = false;
    std::thread other([&] {
        while (!is_over) lost();
    });
    for (int i = 0; i < 5000; ++i) {
        RecoveryFile file(folder());
        file.record(kSphere);
        EXPECT_TRUE(fs::exists(file.path())) << "start " << i;
        file.remove();
    }
    is_over = true;
    other.join();
}

TEST_F(RecoveryTest, OnlyOneWindowAtATimeOffersASession) {
    lose({kSphere, kDrag});
    {
        const auto offered = lost();
        EXPECT_EQ(offered.size(), 1u);
        EXPECT_TRUE(lost().empty());
    }
    EXPECT_EQ(lost().size(), 1u);
}

// The first commands and an error in the model do not remove the notices of the start, and the
// notices do not remove the error.
TEST_F(RecoveryTest, NoticesOfTheStartStayUntilTheyAreDismissed) {
    write("state", "a file in place of the folder");
    write("letter.obj", "Dear sphere\n");
    for (const std::string& model : {std::string(), path("letter.obj")}) {
        Editor editor({}, std::chrono::hours(1));
        editor.workspace().begin_recovery(folder());
        editor.workspace().add_notice("this record is in record-2.jsonl");
        editor.begin(model);
        const std::string message = editor.workspace().message();
        EXPECT_NE(message.find("recovery"), std::string::npos) << message;
        EXPECT_NE(message.find("record-2.jsonl"), std::string::npos) << message;
        EXPECT_EQ(message.find("letter.obj") != std::string::npos, !model.empty()) << message;
        key(editor, Key::escape);
        EXPECT_EQ(editor.workspace().message(), "");
    }
}

}  // namespace
}  // namespace pectin

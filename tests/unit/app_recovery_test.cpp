// Records that are never overwritten, and sessions that can be restored.
#include "app/recovery.h"

#include <sys/stat.h>

#include <fstream>

#include "io/file_error.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

const command::Shape kSphere{command::Shape::Kind::sphere, 3};
const command::Drag kDrag{.moves = {{.from = Vec3(0, 0, 1), .to = Vec3(0, 0, 1.4)}}};

class RecoveryTest : public EditorTest {
  protected:
    std::string folder() const { return path("state"); }
    std::size_t file_count() const {
        if (!fs::exists(folder())) return 0;
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder()), fs::directory_iterator()));
    }
    // What a session that did all this leaves when it ends badly.
    void lose(const std::vector<Command>& commands) const {
        RecoveryFile file(folder());
        for (const Command& command : commands) file.record(command);
    }
    static std::string error_of(const std::string& path) {
        try {
            const Recorder recorder(path);
            return {};
        } catch (const FileError& error) {
            return error.what();
        }
    }
};

TEST_F(RecoveryTest, FindsWhatWasNotSavedAndNothingElse) {
    EXPECT_TRUE(find_lost_sessions(folder()).empty()) << "no folder yet";
    lose({kSphere});                                       // nothing was done
    lose({kSphere, kDrag, command::Save{path("a.obj")}});  // all is saved
    lose({kSphere, kDrag, command::Save{path("b.obj")}, kDrag});
    const auto sessions = find_lost_sessions(folder());
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
    EXPECT_TRUE(find_lost_sessions(folder()).empty());
    EXPECT_TRUE(fs::exists(running.path()));
    running.remove();
    EXPECT_FALSE(fs::exists(running.path()));
}

TEST_F(RecoveryTest, ReadsAFileThatWasCutOffInTheMiddleOfALine) {
    lose({kSphere, kDrag, kDrag});
    const std::string file = find_lost_sessions(folder()).at(0).path;
    fs::resize_file(file, fs::file_size(file) - 20);
    const auto sessions = find_lost_sessions(folder());
    ASSERT_EQ(sessions.size(), 1u);
    EXPECT_EQ(sessions[0].commands, (std::vector<Command>{kSphere, kDrag}));
}

TEST_F(RecoveryTest, LeavesOtherFilesOfTheFolderAlone) {
    fs::create_directory(folder());
    write("state/notes.txt", "mine");
    write("state/recovery-1-0.jsonl", "not a script");
    ::mkfifo(path("state/recovery-2-0.jsonl").c_str(), 0600);
    EXPECT_TRUE(find_lost_sessions(folder()).empty());
    EXPECT_EQ(read("state/notes.txt"), "mine");
}

TEST_F(RecoveryTest, RestoresTheObjectToTheByteAndWritesNoFile) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const std::vector<Command> commands{
        command::Open{path("a.obj")}, command::Brush{.radius = 0.8},
        command::Drag{.moves = {{.from = Vec3(0, 0, 1), .to = Vec3(0, 0.2, 1.4)}}},
        command::Save{path("a.obj")},
        command::Drag{.moves = {{.from = Vec3(1, 0, 0), .to = Vec3(1.3, 0, 0)}}}};
    Session direct;
    for (const Command& command : commands) {
        if (!is_restored(command)) continue;
        ASSERT_FALSE(direct.execute(command));
    }
    lose(commands);
    const std::string before = read("a.obj");
    Editor editor = this->editor();
    editor.offer(find_lost_sessions(folder()));
    ASSERT_TRUE(editor.has_dialog());
    editor.answer_recovery(Editor::RecoveryAnswer::restore);
    EXPECT_FALSE(editor.has_dialog());
    EXPECT_EQ(read("a.obj"), before);
    EXPECT_EQ(file_count(), 0u);
    ASSERT_TRUE(editor.workspace().is_modified());
    editor.execute(command::Save{path("restored.obj")});
    ASSERT_FALSE(direct.execute(command::Save{path("direct.obj")}));
    EXPECT_EQ(read("restored.obj"), read("direct.obj"));
}

TEST_F(RecoveryTest, ASessionBeingRestoredIsKeptItself) {
    lose({kSphere, kDrag});
    Editor editor = this->editor();
    auto sessions = find_lost_sessions(folder());
    editor.workspace().begin_recovery(folder());
    editor.offer(std::move(sessions));
    editor.answer_recovery(Editor::RecoveryAnswer::restore);
    EXPECT_EQ(file_count(), 1u) << "of this session, which holds the restored commands, too";
    editor.workspace().end_recovery();
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(RecoveryTest, WhatCannotBeRestoredStaysInAFileThatIsNamed) {
    lose({kSphere, kDrag, command::Open{path("gone.obj")}, kDrag});
    Editor editor = this->editor();
    editor.offer(find_lost_sessions(folder()));
    editor.answer_recovery(Editor::RecoveryAnswer::restore);
    const std::string message = editor.workspace().message();
    EXPECT_NE(message.find("Restored up to command 2 of 4"), std::string::npos) << message;
    EXPECT_NE(message.find(".incomplete"), std::string::npos) << message;
    EXPECT_EQ(file_count(), 1u);
    EXPECT_TRUE(find_lost_sessions(folder()).empty()) << "it is not offered again";
}

TEST_F(RecoveryTest, LaterKeepsAllAndDiscardForgetsOne) {
    lose({kSphere, kDrag});
    lose({kSphere, kDrag});
    Editor editor = this->editor();
    editor.offer(find_lost_sessions(folder()));
    editor.answer_recovery(Editor::RecoveryAnswer::discard);
    EXPECT_TRUE(editor.offered_session()) << "the second one";
    EXPECT_EQ(file_count(), 1u);
    key(editor, Key::escape);
    EXPECT_FALSE(editor.offered_session());
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(RecoveryTest, AFolderThatCannotBeWrittenIsSaidAndStopsNothing) {
    write("state", "a file in place of the folder");
    Editor editor = this->editor();
    editor.workspace().begin_recovery(folder());
    EXPECT_NE(editor.workspace().message().find("recovery"), std::string::npos);
    EXPECT_FALSE(editor.workspace().has_recovery());
    EXPECT_TRUE(editor.execute(command::Brush{.radius = 0.3}));
}

TEST_F(RecoveryTest, ARecordGoesOnBesideAnEarlierOne) {
    const std::string wanted = path("record.jsonl");
    { Recorder(wanted).record(kSphere); }
    const std::string first = read("record.jsonl");
    const Recorder second(wanted), third(wanted);
    EXPECT_EQ(second.path(), path("record-2.jsonl"));
    EXPECT_EQ(third.path(), path("record-3.jsonl"));
    EXPECT_EQ(read("record.jsonl"), first);
    write("empty.jsonl", "");
    EXPECT_EQ(Recorder(path("empty.jsonl")).path(), path("empty.jsonl"));
}

TEST_F(RecoveryTest, RecordsGoToOrdinaryFilesOnly) {
    ::mkfifo(path("pipe").c_str(), 0600);
    EXPECT_NE(error_of(path("pipe")).find("device or a pipe"), std::string::npos);
    EXPECT_NE(error_of("/dev/null").find("device or a pipe"), std::string::npos);
    EXPECT_NE(error_of(path("")).find("cannot be written"), std::string::npos);
    write("model.obj", "v 0 0 0\n");
    EXPECT_NE(error_of(path("model.obj")).find("is no record"), std::string::npos);
    EXPECT_EQ(read("model.obj"), "v 0 0 0\n");
}

}  // namespace
}  // namespace pectin

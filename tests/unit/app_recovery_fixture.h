// Sessions that end unexpectedly, and an Editor that restores them.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/recovery_file.h"
#include "io/file_error.h"
#include "support/file_size_limit.h"
#include "support/small_files.h"
#include "unit/app_editor_fixture.h"

namespace pectin {

inline const command::Shape kSphere{command::Shape::Kind::sphere, 3};
inline const command::Drag kDrag{.moves = {{.from = Vec3(0, 0, 1), .to = Vec3(0, 0, 1.4)}}};

inline constexpr const char* kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";
inline const command::Brush kWide{.radius = 0.8};
// Drags for both models. The second one grabs another point than the first.
inline const command::Drag kFirst{.moves = {{.from = Vec3(0, 0, 1), .to = Vec3(0, 0.2, 1.4)}}};
inline const command::Drag kSecond{.moves = {{.from = Vec3(1, 0, 0), .to = Vec3(1.3, 0, 0)}}};

class RecoveryTest : public EditorTest {
  protected:
    std::string folder() const { return path("state"); }
    std::size_t file_count() const {
        if (!fs::exists(folder())) return 0;
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder()), fs::directory_iterator()));
    }
    // Writes the recovery file that a session with these commands leaves after a crash.
    void lose(const std::vector<Command>& commands) const {
        RecoveryFile file(folder());
        for (const Command& command : commands) file.record(command);
    }
    std::vector<LostSession> lost() const { return find_lost_sessions(folder()).sessions; }
    // An editor that keeps its commands in the state folder.
    PreparedEditor recovering_editor() const {
        return PreparedEditor({}, std::chrono::hours(1),
                              [this](Editor& made) { made.workspace().begin_recovery(folder()); });
    }
    // Executes the commands in an editor that ends without end_recovery(), as after a crash.
    void crash_after(const std::vector<Command>& commands) const {
        auto editor = recovering_editor();
        for (const Command& command : commands) {
            ASSERT_TRUE(editor.execute(command)) << editor.workspace().message();
        }
    }
    // The same without what the editor does by itself after a command.
    void crash_after_exactly(const std::vector<Command>& commands) const {
        auto editor = recovering_editor();
        for (const Command& command : commands) {
            ASSERT_EQ(editor.workspace().execute(command), Workspace::Outcome::done);
        }
    }
    static void finish_restoring(Editor& editor) {
        while (editor.document().restoration()) editor.advance();
    }
    static void restore(Editor& editor, std::vector<LostSession> sessions) {
        editor.document().offer(std::move(sessions));
        ASSERT_TRUE(editor.document().offered_session());
        editor.document().answer_recovery(DocumentController::RecoveryAnswer::restore);
        finish_restoring(editor);
    }
    void restore(Editor& editor) const { restore(editor, lost()); }
    // As at the start of a window, whose commands are then kept, too.
    void restore_and_begin_recovery(Editor& editor) const {
        std::vector<LostSession> sessions = lost();
        editor.workspace().begin_recovery(folder());
        restore(editor, std::move(sessions));
    }
    // Returns the saved bytes that these commands give without any recovery.
    std::string bytes_after(const std::vector<Command>& commands) const {
        Session session;
        for (const Command& command : commands) EXPECT_TRUE(session.execute(command));
        EXPECT_TRUE(session.execute(command::Save{path("direct.obj")}));
        return read("direct.obj");
    }
    std::string bytes_of(Editor& editor) const {
        EXPECT_TRUE(editor.execute(command::Save{path("restored.obj")}));
        return read("restored.obj");
    }
};

}  // namespace pectin

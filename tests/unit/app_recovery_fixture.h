// Sessions that end unexpectedly, and an Editor that restores them.
#pragma once

#include <signal.h>
#include <sys/resource.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "app/recovery_file.h"
#include "io/file_error.h"
#include "unit/app_editor_fixture.h"

namespace pectin {

inline const command::Shape kSphere{command::Shape::Kind::sphere, 3};
inline const command::Drag kDrag{.moves = {{.from = Vec3(0, 0, 1), .to = Vec3(0, 0, 1.4)}}};

inline constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
inline constexpr const char* kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";
inline const command::Brush kWide{.radius = 0.8};
// Drags for both models. The second one grabs another point than the first.
inline const command::Drag kFirst{.moves = {{.from = Vec3(0, 0, 1), .to = Vec3(0, 0.2, 1.4)}}};
inline const command::Drag kSecond{.moves = {{.from = Vec3(1, 0, 0), .to = Vec3(1.3, 0, 0)}}};

// Limits the size of all files that this process writes, for the lifetime of the object.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(std::uintmax_t bytes) {
        struct sigaction ignore {};
        ignore.sa_handler = SIG_IGN;
        ::sigaction(SIGXFSZ, &ignore, &before_);
        ::getrlimit(RLIMIT_FSIZE, &limit_);
        const rlimit lower{static_cast<rlim_t>(bytes), limit_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &lower);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &limit_);
        ::sigaction(SIGXFSZ, &before_, nullptr);
    }

  private:
    rlimit limit_{};
    struct sigaction before_ {};
};

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
    // Executes the commands in an editor that ends without end_recovery(), as after a crash.
    void crash_after(const std::vector<Command>& commands) const {
        Editor editor({}, std::chrono::hours(1));
        editor.workspace().begin_recovery(folder());
        for (const Command& command : commands) {
            ASSERT_TRUE(editor.execute(command)) << editor.workspace().message();
        }
    }
    static void finish_restoring(Editor& editor) {
        while (editor.restoration()) editor.advance();
    }
    void restore(Editor& editor) const {
        editor.offer(lost());
        ASSERT_TRUE(editor.offered_session());
        editor.answer_recovery(Editor::RecoveryAnswer::restore);
        finish_restoring(editor);
    }
    // Returns the saved bytes that these commands give without any recovery.
    std::string bytes_after(const std::vector<Command>& commands) const {
        Session session;
        for (const Command& command : commands) EXPECT_FALSE(session.execute(command));
        EXPECT_FALSE(session.execute(command::Save{path("direct.obj")}));
        return read("direct.obj");
    }
    std::string bytes_of(Editor& editor) const {
        EXPECT_TRUE(editor.execute(command::Save{path("restored.obj")}));
        return read("restored.obj");
    }
};

}  // namespace pectin

// Tests how signals end a replay, and what does not end it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/replay.h"
#include "io/file_descriptor.h"
#include "replay/program.h"
#include "support/paths.h"
#include "support/process.h"

namespace pectin {
namespace {

const std::string kSphere = R"({"cmd": "shape", "kind": "sphere", "resolution": 2})";
const std::string kBrush = R"({"cmd": "brush", "radius": 0.5})";

// Starts a program that replays a script from a pipe and so waits for more lines.
class WaitingReplay {
  public:
    // words: the command line of a program that replays its standard input.
    WaitingReplay(const ScratchFolder& folder, const std::vector<std::string>& lines,
                  const std::vector<std::string>& words = {test::program_path(), "replay", "-"})
        : folder_(&folder) {
        ::mkfifo(folder.path("pipe").c_str(), 0600);
        program_.emplace(words, Environment{}, folder.path("err"), folder.path("pipe"));
        std::ofstream pipe(folder.path("pipe"));
        pipe << "{\"pectin\": 1}\n";
        for (const std::string& line : lines) pipe << line << '\n';
    }
    Process& program() { return *program_; }
    std::string said() const { return folder_->read("err"); }

  private:
    const ScratchFolder* folder_;
    std::optional<Process> program_;
};

TEST(ReplaySignals, EndItWithStatus128PlusTheSignalAndReportWhatWasDone) {
    for (const auto& [signal, name] : {std::pair{SIGINT, "SIGINT"}, std::pair{SIGTERM, "SIGTERM"},
                                       std::pair{SIGHUP, "SIGHUP"}}) {
        const ScratchFolder folder;
        WaitingReplay replay(
            folder,
            {kSphere, kBrush, R"({"cmd": "save", "path": ")" + folder.path("done.obj") + R"("})"});
        ASSERT_TRUE(eventually([&] { return folder.holds("done.obj"); })) << replay.said();
        replay.program().signal(signal);
        EXPECT_EQ(replay.program().wait(), 128 + signal);
        // The file appears shortly before the command that saves it is finished.
        const std::string ending = std::string("ended by ") + name + "; ";
        EXPECT_TRUE(replay.said() == "pectin: " + ending + "3 commands are done\n" ||
                    replay.said() ==
                        "standard input:4: save: " + ending + "2 commands before it are done\n")
            << replay.said();
    }
}

TEST(ReplaySignals, DuringASaveLeaveTheOldFileAndNoTemporaryFile) {
    const ScratchFolder folder;
    folder.write("large.obj", "old\n");
    const std::string script =
        write_script(folder, "s.jsonl",
                     {R"({"cmd": "shape", "kind": "sphere", "resolution": 8})",
                      R"({"cmd": "save", "path": "large.obj"})"});
    Process program({test::program_path(), "replay", script}, {}, folder.path("err"));
    const auto writes = [&] {
        const auto files = folder.files();
        return std::any_of(files.begin(), files.end(),
                           [](const std::string& name) { return name.ends_with(".tmp"); });
    };
    ASSERT_TRUE(eventually([&] { return writes() || program.wait({}); }));
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), 130) << "if it is 0, the save was over before the signal came";
    EXPECT_FALSE(writes());
    EXPECT_EQ(folder.read("large.obj"), "old\n");
    EXPECT_NE(
        folder.read("err").find("s.jsonl:3: save: ended by SIGINT; 1 command before it is done"),
        std::string::npos)
        << folder.read("err");
}

TEST(ReplaySignals, StayIgnoredIfTheyWereIgnoredBefore) {
    const ScratchFolder folder;
    struct sigaction ignore {
    }, before{};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGHUP, &ignore, &before);
    WaitingReplay replay(folder, {kSphere});
    ::sigaction(SIGHUP, &before, nullptr);
    replay.program().signal(SIGHUP);
    EXPECT_FALSE(replay.program().wait(std::chrono::milliseconds(300)));
    replay.program().signal(SIGTERM);
    EXPECT_EQ(replay.program().wait(), 143);
}

// The reader of the error output has stopped reading.
TEST(ReplaySignals, EndItEvenIfItsErrorOutputIsBlocked) {
    const ScratchFolder folder;
    ::mkfifo(folder.path("err").c_str(), 0600);
    const FileDescriptor reader(folder.path("err").c_str(), O_RDWR | O_NONBLOCK);
    ASSERT_TRUE(reader.is_open());
    const std::string filling(4096, 'x');
    while (::write(reader.get(), filling.data(), filling.size()) > 0) {
    }
    WaitingReplay replay(
        folder, {kSphere, R"({"cmd": "save", "path": ")" + folder.path("done.obj") + R"("})"});
    ASSERT_TRUE(eventually([&] { return folder.holds("done.obj"); }));
    replay.program().signal(SIGTERM);
    EXPECT_EQ(replay.program().wait(std::chrono::seconds(20)), 143);
}

TEST(ReplayStatus, EscapesControlCharactersOfThePath) {
    ReplayStatus status;
    status.begin("a\x1b[31m.jsonl", 3, "save");
    EXPECT_EQ(status.exit_message("SIGINT"),
              "a\\x1B[31m.jsonl:3: save: ended by SIGINT; 0 commands before it are done");
}

// Otherwise the first file that is opened would receive the messages.
TEST(ReplayStandardFiles, AreOpenEvenIfTheyWereClosedAtTheStart) {
    const ScratchFolder folder;
    const WaitingReplay replay(
        folder, {kSphere, R"({"cmd": "save", "path": ")" + folder.path("done.obj") + R"("})"},
        {"/bin/sh", "-c", "echo $$ >\"$1\"; exec \"$0\" replay - 1>&- 2>&-", test::program_path(),
         folder.path("id")});
    ASSERT_TRUE(eventually([&] { return folder.holds("done.obj"); }));
    const std::string id = folder.read("id");
    for (const char* number : {"1", "2"}) {
        const std::string link = "/proc/" + id.substr(0, id.find('\n')) + "/fd/" + number;
        std::error_code error;
        EXPECT_EQ(std::filesystem::read_symlink(link, error), "/dev/null") << error.message();
    }
}

// Writes a script whose second command prints a message and whose last command writes a file.
std::string talkative_script(const ScratchFolder& folder) {
    // A face that contains a vertex twice is kept and reported.
    folder.write("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
    return write_script(
        folder, "s.jsonl",
        {R"({"cmd": "open", "path": "model.obj"})", R"({"cmd": "save", "path": "last.obj"})"});
}

TEST(ReplaySignals, FromAClosedPipeDoNotPreventLaterCommands) {
    const ScratchFolder folder;
    const std::string script = talkative_script(folder);
    ASSERT_NE(run_program({"replay", script}).err, "") << "it has something to say";
    std::filesystem::remove(folder.path("last.obj"));
    // The reader of the pipe ends before the program prints anything.
    Process shell(
        {"/bin/sh", "-c", "(sleep 0.3; \"$0\" replay \"$1\" 2>&1; echo $? >\"$2\") | true",
         test::program_path(), script, folder.path("status")},
        {});
    ASSERT_TRUE(
        eventually([&] { return folder.holds("status") && !folder.read("status").empty(); }));
    EXPECT_EQ(folder.read("status"), "0\n");
    EXPECT_TRUE(folder.holds("last.obj"));
}

TEST(ReplaySignals, FromAFileSizeLimitAreAnErrorOfThatFileOnly) {
    const ScratchFolder folder;
    const std::string script =
        write_script(folder, "s.jsonl",
                     {R"({"cmd": "shape", "kind": "sphere", "resolution": 5})",
                      R"({"cmd": "save", "path": "large.obj"})"});
    Process shell(
        {"/bin/sh", "-c", "ulimit -f 8; exec \"$0\" replay \"$1\"", test::program_path(), script},
        {}, folder.path("err"));
    EXPECT_EQ(shell.wait(), 1);
    EXPECT_NE(folder.read("err").find("larger than files may be"), std::string::npos)
        << folder.read("err");
    EXPECT_EQ(folder.files(), (std::set<std::string>{"err", "s.jsonl"}));
}

TEST(ReplayInput, RefusesAFileOfEndlessZeros) {
    const Outcome outcome = run_program({"replay", "/dev/zero"});
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_NE(outcome.err.find("/dev/zero:1: script: the line is longer than 64 MiB"),
              std::string::npos)
        << outcome.err;
}

}  // namespace
}  // namespace pectin

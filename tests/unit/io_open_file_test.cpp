// Tests that opening and reading never block: anything but a regular file is refused at once, and a
// file system that does not answer is given up after a time limit.
#include "io/open_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <set>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "app/background_task.h"
#include "io/atomic_file.h"
#include "io/file_error.h"
#include "io/obj_reader.h"
#include "io/read_file.h"
#include "support/scratch_folder.h"
#include "support/small_files.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class OpenFileTest : public testing::Test {
  protected:
    OpenFileTest() { folder_.write("a.obj", kTriangle); }
    std::string path(const std::string& name) const { return folder_.path(name); }

    static std::string refusal(const std::string& path) {
        try {
            read_obj(path);
        } catch (const FileError& error) {
            return error.message();
        }
        return "read";
    }
    ScratchFolder folder_;
};

TEST_F(OpenFileTest, RefusesAPipeThatNobodyWritesToWithoutWaiting) {
    ASSERT_EQ(::mkfifo(path("pipe.obj").c_str(), 0600), 0);
    const auto begin = Clock::now();
    EXPECT_EQ(refusal(path("pipe.obj")),
              "is a pipe, not a file; write what comes out of it to a file first");
    fs::create_symlink("pipe.obj", path("link.obj"));
    EXPECT_EQ(refusal(path("link.obj")).substr(0, 9), "is a pipe");
    EXPECT_LT(Clock::now() - begin, 1s);
}

TEST_F(OpenFileTest, RefusesDevicesSocketsAndFolders) {
    EXPECT_EQ(refusal("/dev/zero"), "is a device, not a file");
    EXPECT_EQ(refusal("/dev/null"), "is a device, not a file");
    EXPECT_EQ(refusal(folder_.path()), "is a folder, not a file");
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
    const std::string at = path("s");
    ASSERT_LT(at.size(), sizeof address.sun_path);
    std::memcpy(address.sun_path, at.c_str(), at.size());
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(refusal(at), "is a socket, not a file");
    ::close(socket);
}

TEST_F(OpenFileTest, OpensARegularFileAndReadsItToItsEnd) {
    FileAccess access;
    const OpenFile file = access.open(path("a.obj"));
    EXPECT_EQ(file.bytes, fs::file_size(path("a.obj")));
    EXPECT_EQ(access.read(file, path("a.obj"), 0, 4), "v 0 ");
    EXPECT_EQ(access.read(file, path("a.obj"), 4, 100).size(), file.bytes - 4);
    EXPECT_EQ(access.read(file, path("a.obj"), file.bytes, 100), "");
}

TEST_F(OpenFileTest, ReadsFilesWhoseReportedSizeIsZero) {
    EXPECT_FALSE(read_whole_file("/proc/self/status").empty());
}

// A stand-in for the system that answers only when it is told to. The destructor tells it to, and
// the thread that asked may end later than this object.
struct DeadMount {
    std::shared_ptr<std::atomic<bool>> is_back = std::make_shared<std::atomic<bool>>(false);

    FileOptions options(std::chrono::milliseconds timeout) const {
        return {timeout, [is_back = is_back](const std::string& path) {
                    while (!*is_back) std::this_thread::sleep_for(1ms);
                    return ask_system(path);
                }};
    }
    ~DeadMount() { *is_back = true; }
};

TEST_F(OpenFileTest, GivesUpOnAFileSystemThatDoesNotAnswer) {
    const DeadMount mount;
    const auto begin = Clock::now();
    try {
        FileAccess(mount.options(100ms)).open(path("a.obj"));
        FAIL() << "was opened";
    } catch (const FileError& error) {
        EXPECT_TRUE(error.message().starts_with("does not answer; ")) << error.message();
    }
    EXPECT_LT(Clock::now() - begin, 5s);
}

TEST_F(OpenFileTest, CanBeCancelledWhileTheFileSystemDoesNotAnswer) {
    const DeadMount mount;
    std::stop_source stop;
    std::jthread user([&stop] {
        std::this_thread::sleep_for(100ms);
        stop.request_stop();
    });
    const auto begin = Clock::now();
    EXPECT_THROW(FileAccess(mount.options(1h)).open(path("a.obj"), Progress(stop.get_token(), {})),
                 Cancelled);
    EXPECT_LT(Clock::now() - begin, 5s);
}

TEST_F(OpenFileTest, AsksAboutManyFilesOnOneOtherThread) {
    const auto threads = std::make_shared<std::set<std::thread::id>>();
    FileAccess access({1h, [threads](const std::string& path) {
                           threads->insert(std::this_thread::get_id());
                           return ask_system(path);
                       }});
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(access.ask(path("a.obj")).error, 0);
        EXPECT_EQ(access.ask(path("none.obj")).error, ENOENT);
    }
    EXPECT_EQ(threads->size(), 1u);
    EXPECT_FALSE(threads->contains(std::this_thread::get_id()));
}

TEST_F(OpenFileTest, WaitsOnlyOnceForAFileSystemThatDoesNotAnswer) {
    const DeadMount mount;
    FileAccess access(mount.options(100ms));
    const auto begin = Clock::now();
    for (int i = 0; i < 100; ++i) EXPECT_THROW(access.ask(path("a.obj")), FileError);
    EXPECT_LT(Clock::now() - begin, 5s);
}

TEST_F(OpenFileTest, RethrowsExceptionsOfTheOtherThread) {
    bool is_first = true;
    FileAccess access({1h, [&is_first](const std::string& path) {
                           if (std::exchange(is_first, false)) throw std::bad_alloc();
                           return ask_system(path);
                       }});
    EXPECT_THROW(access.ask(path("a.obj")), std::bad_alloc);
    EXPECT_EQ(access.ask(path("a.obj")).error, 0);
}

// A file that opens and whose reads then wait for a pipe that nobody writes to, as on a server that
// stops answering.
class StoppedServer {
  public:
    StoppedServer() {
        if (::pipe(pipe_->ends.data()) != 0) ADD_FAILURE() << "no pipe";
    }
    ~StoppedServer() { ::close(pipe_->ends[1]); }
    // answers: how many pieces are read before the server stops.
    FileOptions options(std::chrono::milliseconds timeout, int answers = 0) const {
        FileOptions options{.timeout = timeout};
        options.read = [pipe = pipe_, left = answers](const OpenFile& file, std::size_t offset,
                                                      char* to, std::size_t most) mutable {
            if (left-- > 0) return read_system(file, offset, to, std::min<std::size_t>(most, 1));
            return ::read(pipe->ends[0], to, most);
        };
        return options;
    }

  private:
    // Also owned by the thread that reads, which may outlive the server.
    struct Pipe {
        std::array<int, 2> ends{};
        ~Pipe() { ::close(ends[0]); }
    };
    std::shared_ptr<Pipe> pipe_ = std::make_shared<Pipe>();
};

TEST_F(OpenFileTest, GivesUpOnAReadThatHangsAfterTheFileWasOpened) {
    const StoppedServer server;
    for (const int answers : {0, 3}) {
        const auto begin = Clock::now();
        try {
            read_whole_file(path("a.obj"), {}, 1 << 20, server.options(100ms, answers));
            ADD_FAILURE() << "was read";
        } catch (const FileError& error) {
            EXPECT_TRUE(error.message().starts_with("does not answer; ")) << error.message();
        }
        EXPECT_LT(Clock::now() - begin, 5s);
    }
}

// The window opens models in such a task, whose destructor waits for its end.
TEST_F(OpenFileTest, LetsATaskBeCancelledWhileItsReadHangs) {
    const StoppedServer server;
    BackgroundTask<std::string> task([&](const Progress& progress) {
        return read_whole_file(path("a.obj"), progress, 1 << 20, server.options(1h));
    });
    EXPECT_FALSE(task.has_ended(100ms));
    const auto begin = Clock::now();
    task.cancel();
    EXPECT_THROW(task.take(), Cancelled);
    EXPECT_LT(Clock::now() - begin, 5s);
}

TEST_F(OpenFileTest, WaitsLongerThanTheTimeLimitForASlowServerThatGoesOn) {
    FileOptions options{.timeout = 2s};
    options.read = [](const OpenFile& file, std::size_t offset, char* to, std::size_t most) {
        std::this_thread::sleep_for(20ms);
        return read_system(file, offset, to, std::min<std::size_t>(most, 1));
    };
    folder_.write("a.obj", kTriangle + std::string(150, '\n'));
    ASSERT_GT(fs::file_size(path("a.obj")) * 20, 2000u);
    EXPECT_EQ(read_whole_file(path("a.obj"), {}, 1 << 20, options), read_whole_file(path("a.obj")));
}

TEST_F(OpenFileTest, ReportsTheErrorOfARead) {
    FileOptions options;
    options.read = [](const OpenFile&, std::size_t, char*, std::size_t) -> ssize_t {
        errno = EIO;
        return -1;
    };
    try {
        read_whole_file(path("a.obj"), {}, 1 << 20, options);
        FAIL() << "was read";
    } catch (const FileError& error) {
        EXPECT_EQ(error.message(), "cannot be read: " + std::generic_category().message(EIO));
    }
}

}  // namespace
}  // namespace pectin

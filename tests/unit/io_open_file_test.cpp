// Tests that opening never blocks: anything but a regular file is refused at once, and a file
// system that does not answer is given up after a time limit.
#include "io/open_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

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
#include <thread>
#include <utility>

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
    const OpenFile file = open_file(path("a.obj"));
    EXPECT_EQ(file.bytes, fs::file_size(path("a.obj")));
    std::string bytes(100, 'x');
    EXPECT_EQ(read_bytes(file, path("a.obj"), bytes.data(), 4), 4u);
    EXPECT_EQ(bytes.substr(0, 4), "v 0 ");
    EXPECT_EQ(read_bytes(file, path("a.obj"), bytes.data(), 100), file.bytes - 4);
    EXPECT_EQ(read_bytes(file, path("a.obj"), bytes.data(), 100), 0u);
}

TEST_F(OpenFileTest, ReadsFilesWhoseReportedSizeIsZero) {
    EXPECT_FALSE(read_whole_file("/proc/self/status").empty());
}

// A stand-in for the system that answers only when it is told to.
struct DeadMount {
    std::shared_ptr<std::atomic<bool>> is_back = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<std::atomic<bool>> has_answered = std::make_shared<std::atomic<bool>>(false);

    QueryOptions options(std::chrono::milliseconds timeout) const {
        return {timeout, [is_back = is_back, has_answered = has_answered](const std::string& path) {
                    while (!*is_back) std::this_thread::sleep_for(1ms);
                    FileAnswer answer = ask_system(path);
                    *has_answered = true;
                    return answer;
                }};
    }
    ~DeadMount() {
        *is_back = true;
        while (!*has_answered) std::this_thread::sleep_for(1ms);
    }
};

TEST_F(OpenFileTest, GivesUpOnAFileSystemThatDoesNotAnswer) {
    const DeadMount mount;
    const auto begin = Clock::now();
    try {
        open_file(path("a.obj"), {}, mount.options(100ms));
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
    EXPECT_THROW(open_file(path("a.obj"), Progress(stop.get_token(), {}), mount.options(1h)),
                 Cancelled);
    EXPECT_LT(Clock::now() - begin, 1s);
}

TEST_F(OpenFileTest, AsksAboutManyFilesOnOneOtherThread) {
    const auto threads = std::make_shared<std::set<std::thread::id>>();
    TimedFileQuery query({1h, [threads](const std::string& path) {
                              threads->insert(std::this_thread::get_id());
                              return ask_system(path);
                          }});
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(query.ask(path("a.obj")).error, 0);
        EXPECT_EQ(query.ask(path("none.obj")).error, ENOENT);
    }
    EXPECT_EQ(threads->size(), 1u);
    EXPECT_FALSE(threads->contains(std::this_thread::get_id()));
}

TEST_F(OpenFileTest, WaitsOnlyOnceForAFileSystemThatDoesNotAnswer) {
    const DeadMount mount;
    TimedFileQuery query(mount.options(100ms));
    const auto begin = Clock::now();
    for (int i = 0; i < 100; ++i) EXPECT_THROW(query.ask(path("a.obj")), FileError);
    EXPECT_LT(Clock::now() - begin, 5s);
}

TEST_F(OpenFileTest, RethrowsExceptionsOfTheOtherThread) {
    bool is_first = true;
    TimedFileQuery query({1h, [&is_first](const std::string& path) {
                              if (std::exchange(is_first, false)) throw std::bad_alloc();
                              return ask_system(path);
                          }});
    EXPECT_THROW(query.ask(path("a.obj")), std::bad_alloc);
    EXPECT_EQ(query.ask(path("a.obj")).error, 0);
}

}  // namespace
}  // namespace pectin

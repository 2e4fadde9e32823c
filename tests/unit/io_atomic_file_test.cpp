#include "io/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <string>

#include "io/file_error.h"
#include "io/read_file.h"
#include "support/file_size_limit.h"
#include "support/scratch_folder.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::ptrdiff_t file_count() const {
        return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
    }
    static mode_t mode_of(const std::string& path) {
        struct stat status {};
        EXPECT_EQ(::stat(path.c_str(), &status), 0);
        return status.st_mode & 07777;
    }

    ScratchFolder folder_;
};

std::string refusal(const std::string& path) {
    try {
        write_file_atomically(path, "new");
    } catch (const FileError& error) {
        EXPECT_EQ(error.path(), path);
        EXPECT_EQ(error.line(), 0u);
        EXPECT_EQ(error.what(), path + ": " + error.message());
        return error.message();
    }
    ADD_FAILURE() << "wrote " << path;
    return {};
}

TEST(FileError, PrecedesItsMessageWithPathAndLine) {
    EXPECT_STREQ(FileError("a.obj", 7, "is wrong").what(), "a.obj:7: is wrong");
    EXPECT_STREQ(FileError("a.obj", "is wrong").what(), "a.obj: is wrong");
}

TEST_F(AtomicFileTest, WritesAllBytesAndLeavesNothingElse) {
    std::string bytes(3'000'000, 'x');
    bytes[1'234'567] = '\0';
    write_file_atomically(path("a"), bytes);
    EXPECT_EQ(read_whole_file(path("a")), bytes);
    write_file_atomically(path("a"), "");
    EXPECT_EQ(read_whole_file(path("a")), "");
    EXPECT_EQ(file_count(), 1);
}

TEST_F(AtomicFileTest, AppendsPiecesAndChangesNothingBeforeCommit) {
    write_file_atomically(path("a"), "old");
    AtomicFile file(path("a"));
    file.write("new ");
    file.write("content");
    EXPECT_EQ(read_whole_file(path("a")), "old");
    file.commit();
    EXPECT_EQ(read_whole_file(path("a")), "new content");
    EXPECT_EQ(file_count(), 1);
}

TEST_F(AtomicFileTest, LeavesTheOldFileAndNoTemporaryWithoutCommit) {
    write_file_atomically(path("a"), "old");
    { AtomicFile(path("a")).write("new"); }
    EXPECT_EQ(read_whole_file(path("a")), "old");
    EXPECT_EQ(file_count(), 1);
}

TEST_F(AtomicFileTest, LeavesTheOldFileWhenWritingFailsHalfway) {
    write_file_atomically(path("a"), "old");
    {
        const FileSizeLimit limit(1000);
        EXPECT_THROW(write_file_atomically(path("a"), std::string(5000, 'x')), FileError);
    }
    EXPECT_EQ(read_whole_file(path("a")), "old");
    EXPECT_EQ(file_count(), 1);
}

TEST_F(AtomicFileTest, RefusesDevices) {
    EXPECT_NE(refusal("/dev/null").find("device"), std::string::npos);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, ReportsWhatIsWrongWithThePath) {
    EXPECT_NE(refusal(path("missing/a")).find("no folder"), std::string::npos);
    EXPECT_NE(refusal(folder_.path()).find("is a folder"), std::string::npos);
    EXPECT_NE(refusal(path("missing/")).find("names a folder"), std::string::npos);
    EXPECT_NE(refusal(path(std::string(300, 'n'))).find("too long"), std::string::npos);
    EXPECT_EQ(file_count(), 0);
    write_file_atomically(path("file"), "old");
    EXPECT_NE(refusal(path("file/a")).find("is not a folder"), std::string::npos);
    EXPECT_EQ(read_whole_file(path("file")), "old");
    EXPECT_EQ(file_count(), 1);
}

TEST_F(AtomicFileTest, RespectsPermissions) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    write_file_atomically(path("a"), "old");
    fs::permissions(path("a"), fs::perms::owner_read);
    EXPECT_NE(refusal(path("a")).find("write-protected"), std::string::npos);
    fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(refusal(path("b")).find("no permission"), std::string::npos);
    fs::permissions(folder_.path(), fs::perms::owner_all);
    EXPECT_EQ(read_whole_file(path("a")), "old");
}

TEST_F(AtomicFileTest, KeepsTheModeOfTheFileItReplaces) {
    write_file_atomically(path("a"), "old");
    ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
    write_file_atomically(path("a"), "new");
    EXPECT_EQ(mode_of(path("a")), 0640u);
}

TEST_F(AtomicFileTest, GivesNewFilesTheModeOfAnyNewFile) {
    const mode_t mask = ::umask(027);
    write_file_atomically(path("a"), "new");
    ::umask(mask);
    EXPECT_EQ(mode_of(path("a")), 0640u);
}

TEST_F(AtomicFileTest, ReplacesTheTargetOfALinkAndKeepsTheLink) {
    fs::create_directory(path("inner"));
    write_file_atomically(path("inner/target"), "old");
    fs::create_symlink("inner/target", path("link"));
    fs::create_symlink(path("link"), path("link to link"));
    write_file_atomically(path("link to link"), "new");
    EXPECT_EQ(fs::read_symlink(path("link")), "inner/target");
    EXPECT_TRUE(fs::is_symlink(path("link to link")));
    EXPECT_EQ(read_whole_file(path("inner/target")), "new");
    EXPECT_EQ(file_count(), 3);
}

TEST_F(AtomicFileTest, MakesTheTargetOfADanglingLink) {
    fs::create_symlink("target", path("link"));
    write_file_atomically(path("link"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(read_whole_file(path("target")), "new");
}

TEST_F(AtomicFileTest, RefusesCyclicLinks) {
    fs::create_symlink("b", path("a"));
    fs::create_symlink("a", path("b"));
    EXPECT_FALSE(refusal(path("a")).empty());
    EXPECT_EQ(file_count(), 2);
}

TEST_F(AtomicFileTest, WritesDespiteTemporaryFilesOfKilledProcesses) {
    const std::string left = path(".pectin-" + std::to_string(::getpid()) + "-0.tmp");
    write_file_atomically(left, "left behind");
    write_file_atomically(path("a"), "new");
    EXPECT_EQ(read_whole_file(path("a")), "new");
    EXPECT_EQ(read_whole_file(left), "left behind");
}

TEST_F(AtomicFileTest, CommittedAsNewDoesNotReplaceAFileThatExistsByThen) {
    AtomicFile file(path("a"));
    file.write("mine");
    write_file_atomically(path("a"), "theirs");
    try {
        file.commit_new();
        ADD_FAILURE() << "replaced the other";
    } catch (const FileError& error) {
        EXPECT_EQ(error.message(), "is there already; it is not replaced");
    }
    EXPECT_EQ(read_whole_file(path("a")), "theirs");
    AtomicFile other(path("b"));
    other.write("mine");
    other.commit_new();
    EXPECT_EQ(read_whole_file(path("b")), "mine");
}

TEST_F(AtomicFileTest, IsReadBackOrRefusedWithAReason) {
    const auto reason = [](const std::string& path) {
        try {
            read_whole_file(path);
        } catch (const FileError& error) {
            return error.message();
        }
        return std::string("read");
    };
    EXPECT_EQ(reason(path("missing")), "no such file");
    EXPECT_EQ(reason(folder_.path()), "is a folder, not a file");
    EXPECT_EQ(reason("/dev/zero"), "is a device, not a file");
    write_file_atomically(path("a"), "text");
    EXPECT_EQ(reason(path("a")), "read");
    EXPECT_NE(reason(path("a/b")).find("not a folder"), std::string::npos);
}

TEST_F(AtomicFileTest, IsReadOnlyUpToTheGivenSize) {
    write_file_atomically(path("a"), std::string(3 << 20, 'x'));
    EXPECT_EQ(read_whole_file(path("a"), {}, 3 << 20).size(), std::size_t{3} << 20);
    try {
        read_whole_file(path("a"), {}, 2 << 20);
        ADD_FAILURE() << "read more than asked for";
    } catch (const FileError& error) {
        EXPECT_EQ(error.message(), "is larger than 2 MB");
    }
    // A sparse file far larger than the memory.
    fs::resize_file(path("a"), std::uintmax_t{1} << 42);
    EXPECT_THROW(read_whole_file(path("a"), {}, 4 << 20), FileError);
}

}  // namespace
}  // namespace pectin

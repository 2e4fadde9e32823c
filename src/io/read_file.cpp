#include "io/read_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "io/file_descriptor.h"
#include "io/file_error.h"

namespace pectin {
namespace {

[[noreturn]] void fail_to_read(const std::string& path, int error) {
    switch (error) {
        case ENOENT:
            throw FileError(path, "no such file");
        case ENOTDIR:
            throw FileError(path, "no such file; part of its path is not a folder");
        case EACCES:
            throw FileError(path, "no permission to read it");
        case EISDIR:
            throw FileError(path, "is a folder, not a file");
        default:
            throw FileError(path, "cannot be read: " + std::generic_category().message(error));
    }
}

}  // namespace

std::string read_whole_file(const std::string& path, const Progress& progress,
                            std::size_t most_bytes) {
    const FileDescriptor file(path.c_str(), O_RDONLY);
    struct stat status {};
    if (!file.is_open() || ::fstat(file.get(), &status) != 0) fail_to_read(path, errno);
    if (S_ISDIR(status.st_mode)) fail_to_read(path, EISDIR);
    if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode)) {
        throw FileError(path, "is a device, not a file");
    }
    const auto refuse_beyond_most = [&](std::size_t size) {
        if (size <= most_bytes) return;
        throw FileError(path, "is larger than " + std::to_string(most_bytes >> 20) + " MB");
    };
    const auto expected = static_cast<std::size_t>(status.st_size);  // 0 for a pipe
    refuse_beyond_most(expected);

    // One byte more than the file has, so that a single further read finds its end.
    constexpr std::size_t kLeast = 4096;
    constexpr std::size_t kMostAtOnce = std::size_t{4} << 20;
    std::string bytes(std::max(kLeast, expected + 1), '\0');
    std::size_t size = 0;
    while (true) {
        if (size == bytes.size()) bytes.resize(2 * bytes.size());
        const ssize_t got =
            ::read(file.get(), bytes.data() + size, std::min(kMostAtOnce, bytes.size() - size));
        if (got == 0) break;
        if (got < 0 && errno != EINTR) fail_to_read(path, errno);
        if (got > 0) size += static_cast<std::size_t>(got);
        refuse_beyond_most(size);
        progress.advance(size < expected ? static_cast<double>(size) / static_cast<double>(expected)
                                         : 1.0);
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace pectin

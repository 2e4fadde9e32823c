#include "io/open_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <future>
#include <system_error>
#include <thread>
#include <utility>

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

void refuse_what_is_no_file(const std::string& path, mode_t mode) {
    if (S_ISREG(mode)) return;
    if (S_ISDIR(mode)) fail_to_read(path, EISDIR);
    if (S_ISFIFO(mode)) {
        throw FileError(path, "is a pipe, not a file; write what comes out of it to a file first");
    }
    throw FileError(path, S_ISSOCK(mode) ? "is a socket, not a file" : "is a device, not a file");
}

}  // namespace

OpenAnswer ask_patiently(const std::string& path, const Progress& progress,
                         const OpenPatience& patience) {
    // Nothing that the other thread uses belongs to this one, which may be gone first.
    std::packaged_task<OpenAnswer()> task([path, ask = patience.ask] { return ask(path); });
    std::future<OpenAnswer> answer = task.get_future();
    try {
        std::thread(std::move(task)).detach();
    } catch (const std::system_error&) {
        return patience.ask(path);
    }
    constexpr std::chrono::milliseconds kBetweenChecks{20};
    const auto end = std::chrono::steady_clock::now() + patience.longest;
    while (answer.wait_for(kBetweenChecks) != std::future_status::ready) {
        progress.advance(0.0);
        if (std::chrono::steady_clock::now() < end) continue;
        throw FileError(path,
                        "does not answer; is the drive or the server that it is on still "
                        "there?");
    }
    return answer.get();
}

OpenAnswer ask_system(const std::string& path) {
    OpenAnswer answer;
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {.error = errno};
    answer.mode = status.st_mode;
    if (!S_ISREG(status.st_mode)) return answer;
    answer.file.descriptor = FileDescriptor(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY);
    // Something else may have come there since.
    if (!answer.file.descriptor.is_open() || ::fstat(answer.file.descriptor.get(), &status) != 0) {
        return {.error = errno};
    }
    answer.mode = status.st_mode;
    answer.file.bytes = static_cast<std::size_t>(status.st_size);
    return answer;
}

OpenFile opened(const std::string& path, OpenAnswer answer) {
    if (answer.error != 0) fail_to_read(path, answer.error);
    refuse_what_is_no_file(path, answer.mode);
    return std::move(answer.file);
}

OpenFile open_file(const std::string& path, const Progress& progress,
                   const OpenPatience& patience) {
    return opened(path, ask_patiently(path, progress, patience));
}

std::size_t read_bytes(const OpenFile& file, const std::string& path, char* bytes,
                       std::size_t most) {
    std::size_t size = 0;
    while (size < most) {
        const ssize_t got = ::read(file.descriptor.get(), bytes + size, most - size);
        if (got == 0) break;
        if (got < 0 && errno != EINTR) fail_to_read(path, errno);
        if (got > 0) size += static_cast<std::size_t>(got);
    }
    return size;
}

}  // namespace pectin

#include "io/open_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>
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

void refuse_irregular_file(const std::string& path, mode_t mode) {
    if (S_ISREG(mode)) return;
    if (S_ISDIR(mode)) fail_to_read(path, EISDIR);
    if (S_ISFIFO(mode)) {
        throw FileError(path, "is a pipe, not a file; write what comes out of it to a file first");
    }
    throw FileError(path, S_ISSOCK(mode) ? "is a socket, not a file" : "is a device, not a file");
}

// Reads a part of a file in pieces. A call that outlives its caller owns it.
struct Reading {
    // A server of 3 kB/s delivers a piece of this size within the time limit.
    static constexpr std::size_t kPiece = std::size_t{1} << 16;

    decltype(FileOptions::read) read;
    OpenFile file;
    std::string path, bytes;
    std::size_t offset = 0, most = 0;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> is_given_up = false;

    void run();
    double fraction() const {
        if (file.bytes == 0) return 0.0;
        return std::min(1.0, static_cast<double>(offset + done) / static_cast<double>(file.bytes));
    }
};

void Reading::run() {
    bytes.resize(most);
    while (done < most && !is_given_up) {
        const ssize_t got =
            read(file, offset + done, bytes.data() + done, std::min(kPiece, most - done));
        if (got == 0) break;
        if (got < 0 && errno != EINTR) fail_to_read(path, errno);
        if (got > 0) done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
}

FileError no_answer(const std::string& path) {
    return FileError(path,
                     "does not answer; is the drive or the server that it is on still there?");
}

}  // namespace

FileAnswer FileAccess::ask(const std::string& path, const Progress& progress) {
    const auto answer = std::make_shared<FileAnswer>();
    const auto ask = [ask = options_.ask, path, answer] { *answer = ask(path); };
    if (!calls_.run(ask, progress)) throw no_answer(path);
    return std::move(*answer);
}

OpenFile FileAccess::open(const std::string& path, const Progress& progress) {
    return opened(path, ask(path, progress));
}

std::string FileAccess::read(const OpenFile& file, const std::string& path, std::size_t offset,
                             std::size_t most, const Progress& progress) {
    const auto reading = std::make_shared<Reading>();
    reading->read = options_.read;
    reading->file = file;
    reading->path = path;
    reading->offset = offset;
    reading->most = most;
    // If this function throws, the call ends after its present piece.
    const struct GivesUp {
        Reading& reading;
        ~GivesUp() { reading.is_given_up = true; }
    } gives_up{*reading};
    const bool is_done = calls_.run([reading] { reading->run(); }, progress,
                                    [&reading] { return reading->fraction(); });
    if (!is_done) throw no_answer(path);
    progress.advance(reading->fraction());
    return std::move(reading->bytes);
}

FileAnswer ask_system(const std::string& path) {
    FileAnswer answer;
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {.error = errno};
    answer.mode = status.st_mode;
    if (!S_ISREG(status.st_mode)) return answer;
    const auto file =
        std::make_shared<const FileDescriptor>(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY);
    // The path may name something else by now.
    if (!file->is_open() || ::fstat(file->get(), &status) != 0) return {.error = errno};
    answer.file.descriptor = file;
    answer.mode = status.st_mode;
    answer.file.bytes = static_cast<std::size_t>(status.st_size);
    return answer;
}

OpenFile opened(const std::string& path, FileAnswer answer) {
    if (answer.error != 0) fail_to_read(path, answer.error);
    refuse_irregular_file(path, answer.mode);
    return std::move(answer.file);
}

ssize_t read_system(const OpenFile& file, std::size_t offset, char* to, std::size_t most) {
    return ::pread(file.descriptor->get(), to, most, static_cast<off_t>(offset));
}

}  // namespace pectin

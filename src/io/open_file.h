// Opens and reads files without waiting for pipes, devices or file systems that do not answer.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "io/file_descriptor.h"
#include "io/progress.h"
#include "io/timed_calls.h"

namespace pectin {

struct OpenFile {
    // Shared with a call that reads the file and that may outlive the caller's interest.
    std::shared_ptr<const FileDescriptor> descriptor;
    std::size_t bytes = 0;  // size when it was opened
};

// What the system says about a path.
struct FileAnswer {
    int error = 0;    // errno; 0 if there was none
    mode_t mode = 0;  // st_mode of stat(2)
    OpenFile file{};  // open if it is a regular file and `error` is 0
};
// Asks the system about a path and opens it if it is a regular file. Opening a pipe would wait for
// its writer, and opening a device can have side effects. Waits as long as the system does.
FileAnswer ask_system(const std::string& path);

// Reads up to `most` bytes that begin at `offset` into `to`. Returns how many there are (0 at the
// end of the file), or -1 and sets errno. Waits as long as the system does.
ssize_t read_system(const OpenFile& file, std::size_t offset, char* to, std::size_t most);

// How files are opened and read, and how long to wait without an answer. The default is longer than
// a disk takes to start.
struct FileOptions {
    std::chrono::milliseconds timeout{30'000};
    std::function<FileAnswer(const std::string&)> ask = ask_system;
    std::function<ssize_t(const OpenFile&, std::size_t, char*, std::size_t)> read = read_system;
};

// Opens and reads files by TimedCalls. All members throw Cancelled, and FileError if the file
// system does not answer. After that all further calls throw at once.
class FileAccess {
  public:
    explicit FileAccess(FileOptions options = {})
        : options_(std::move(options)), calls_(options_.timeout) {}

    FileAnswer ask(const std::string& path, const Progress& progress = {});
    // Opens the regular file at `path`. Throws FileError if that fails.
    OpenFile open(const std::string& path, const Progress& progress = {});
    // Returns up to `most` bytes that begin at `offset`; fewer only at the end of the file.
    // Progress: the fraction of the file up to the last byte read. path: for messages. Throws
    // FileError.
    std::string read(const OpenFile& file, const std::string& path, std::size_t offset,
                     std::size_t most, const Progress& progress = {});

  private:
    FileOptions options_;
    TimedCalls calls_;
};

// The file of the answer. Throws FileError if it is missing, unreadable or not a regular file.
OpenFile opened(const std::string& path, FileAnswer answer);

}  // namespace pectin

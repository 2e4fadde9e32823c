// Opens files for reading without waiting for pipes, devices or file systems that do not answer.
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

namespace pectin {

struct OpenFile {
    FileDescriptor descriptor;
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

// How open_file() asks the system and how long it waits for an answer. The default is longer than a
// disk takes to start.
struct QueryOptions {
    std::chrono::milliseconds timeout{30'000};
    std::function<FileAnswer(const std::string&)> ask = ask_system;
};

// Asks the system about files with a time limit. A file system may never answer, for instance if
// its server is gone. So another thread asks the system, while the caller waits until `progress`
// asks to stop or the time is over. The other thread then stays until the system answers. If no
// thread can be made, the caller's thread asks.
class TimedFileQuery {
  public:
    explicit TimedFileQuery(QueryOptions options = {}) : options_(std::move(options)) {}
    ~TimedFileQuery();
    TimedFileQuery(const TimedFileQuery&) = delete;
    TimedFileQuery& operator=(const TimedFileQuery&) = delete;

    // Throws FileError if there is no answer. All later calls then throw at once, so that many
    // files take no longer than one. Throws Cancelled.
    FileAnswer ask(const std::string& path, const Progress& progress = {});

  private:
    struct Worker;
    bool start();

    QueryOptions options_;
    std::shared_ptr<Worker> worker_;  // shared with the other thread, which may outlive this
    bool is_waiting_ = false;         // whether an answer is pending
};

// Asks about one path with a TimedFileQuery.
FileAnswer query_file(const std::string& path, const Progress& progress = {},
                      const QueryOptions& options = {});

// The file of the answer. Throws FileError if it is missing, unreadable or not a regular file.
OpenFile opened(const std::string& path, FileAnswer answer);

// Opens the regular file at `path`. Throws FileError, Cancelled.
OpenFile open_file(const std::string& path, const Progress& progress = {},
                   const QueryOptions& options = {});

// Reads up to `most` bytes into `bytes` and returns how many; fewer only at the end of the file.
// path: for messages. Throws FileError.
std::size_t read_bytes(const OpenFile& file, const std::string& path, char* bytes,
                       std::size_t most);

}  // namespace pectin

// Files opened for reading, without waiting for what is no file.
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
    std::size_t bytes = 0;  // its size when it was opened
};

// What the system says of a path.
struct OpenAnswer {
    int error = 0;    // as errno; 0 where it could be asked
    mode_t mode = 0;  // as stat(2) has it
    OpenFile file{};  // open where it is a regular file and `error` is 0
};
// Asks it. Nothing but a regular file is opened: opening a pipe would wait for its writer, and
// opening some devices has consequences. Waits as long as the system does.
OpenAnswer ask_system(const std::string& path);

// How open_file() asks the system, and how long it waits for an answer. A disk that has to start
// first takes less than that.
struct OpenPatience {
    std::chrono::milliseconds longest{30'000};
    std::function<OpenAnswer(const std::string&)> ask = ask_system;
};

// Asks the system about files. A file system may not answer at all, as that of a server that is
// gone. So the system is asked on one other thread, while this one waits until `progress` asks to
// stop or its patience ends. The other thread then stays behind until the system answers. Where no
// thread can be made, this one asks.
class PatientInquiry {
  public:
    explicit PatientInquiry(OpenPatience patience = {}) : patience_(std::move(patience)) {}
    ~PatientInquiry();
    PatientInquiry(const PatientInquiry&) = delete;
    PatientInquiry& operator=(const PatientInquiry&) = delete;

    // Throws FileError where there is no answer; after that at once, for every path, so that many
    // files cost no more than one. Throws Cancelled.
    OpenAnswer ask(const std::string& path, const Progress& progress = {});

  private:
    struct Worker;
    bool start();

    OpenPatience patience_;
    std::shared_ptr<Worker> worker_;  // shared with the other thread, which may outlive this
    bool is_waiting_ = false;         // for an answer that has not come
};

// Asks once.
OpenAnswer ask_patiently(const std::string& path, const Progress& progress = {},
                         const OpenPatience& patience = {});

// The file of the answer. Throws FileError where it is no regular file, missing or unreadable.
OpenFile opened(const std::string& path, OpenAnswer answer);

// Both at once: opens the regular file at `path`.
OpenFile open_file(const std::string& path, const Progress& progress = {},
                   const OpenPatience& patience = {});

// Reads from the file to `bytes`, up to `most` of them and fewer only at its end; how many.
// path: for messages. Throws FileError.
std::size_t read_bytes(const OpenFile& file, const std::string& path, char* bytes,
                       std::size_t most);

}  // namespace pectin

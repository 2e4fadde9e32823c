// Lists the temporary files that are being written, so that they are removed when a signal ends the
// program.
#pragma once

#include <mutex>
#include <string>

namespace pectin {

// Keeps a temporary file in the list. There is one list for the process, because a signal ends the
// process. Thread-safe.
class TemporaryFileEntry {
  public:
    TemporaryFileEntry() = default;
    explicit TemporaryFileEntry(std::string path);
    ~TemporaryFileEntry();
    TemporaryFileEntry(TemporaryFileEntry&& other) noexcept;
    TemporaryFileEntry& operator=(TemporaryFileEntry&& other) noexcept;

    const std::string& path() const { return path_; }

  private:
    std::string path_;  // empty if there is no file
};

// Removes all listed files. Call it on an ordinary thread (not in a signal handler) just before the
// process ends, because files that are still being written are removed, too. While the returned
// lock exists, threads that would add a file wait.
[[nodiscard]] std::unique_lock<std::mutex> remove_temporary_files() noexcept;

}  // namespace pectin

// The temporary files that are being written, so that none is left when a signal ends the program.
#pragma once

#include <mutex>
#include <string>

namespace pectin {

// Names a temporary file for as long as it exists. There is one list for the whole process, since a
// signal ends the whole process. Safe to use on any thread.
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

// Removes all of them. To be called on an ordinary thread (not in a signal handler) right before
// the process ends: files that are still being written lose their names. As long as what is
// returned exists, a thread that would add one waits.
[[nodiscard]] std::unique_lock<std::mutex> remove_temporary_files() noexcept;

}  // namespace pectin

// Writes files either completely or not at all.
#pragma once

#include <string>
#include <string_view>

#include "io/file_descriptor.h"
#include "io/temporary_files.h"

namespace pectin {

// Replaces the file at a path in commit(). Until then, and if anything fails, the old file is
// unchanged. Without commit() no new file is left behind.
//
// The contents go to a temporary file in the same folder, which commit() flushes to the disk and
// renames. So a crash or a power cut leaves either the old file or the new one. The new file keeps
// the permissions of the old one. If the path is a symbolic link, its target is replaced.
// remove_temporary_files() removes the temporary file when a signal ends the program.
// All members throw FileError.
class AtomicFile {
  public:
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();
    // Like commit() for a file that must not exist yet. Throws if it exists by now.
    void commit_new();

  private:
    void open_temporary();
    void flush();
    void finish();
    [[noreturn]] void fail(int error) const;

    std::string path_;    // as given, for messages
    std::string target_;  // the file behind symbolic links
    std::string folder_;
    TemporaryFileEntry temporary_;  // its path is empty if there is no temporary file
    FileDescriptor file_;
};

void write_file_atomically(const std::string& path, std::string_view contents);

}  // namespace pectin

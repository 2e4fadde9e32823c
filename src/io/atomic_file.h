// Files that are either written whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "io/file_descriptor.h"
#include "io/temporary_files.h"

namespace pectin {

// A new content for the file at a path, which takes the place of the old one in commit(). Until
// then, and if anything fails, the old file stays as it is; without commit() nothing is left.
//
// Written to a temporary file in the same folder, flushed to the disk and renamed, so that a
// crash or a power cut leaves the old file or the new one. The new file keeps the old one's
// permissions; a symbolic link stays and its target is replaced. remove_temporary_files() removes
// the temporary file when a signal ends the program.
// All members throw FileError.
class AtomicFile {
  public:
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();
    // The same where there is no file yet; fails where one has come there meanwhile.
    void commit_new();

  private:
    void open_temporary();
    void flush();
    void finish();
    [[noreturn]] void fail(int error) const;

    std::string path_;    // as given, for messages
    std::string target_;  // the file behind symbolic links
    std::string folder_;
    TemporaryFileEntry temporary_;  // its path is empty if there is no file to remove
    FileDescriptor file_;
};

void write_file_atomically(const std::string& path, std::string_view contents);

}  // namespace pectin

// Writes every command as it is done, as a script that replays to the same bytes.
#pragma once

#include <string>

#include "command/command.h"
#include "io/file_descriptor.h"

namespace pectin {

class Recorder {
  public:
    // Begins a new file at the path. If there is a record already, it stays, and this one goes on
    // beside it under the first free name (NAME-2, NAME-3, …). Throws FileError; also if what is
    // there is no record.
    explicit Recorder(const std::string& path);
    // Begins a record in a file that is open and empty.
    Recorder(std::string path, FileDescriptor file);

    const std::string& path() const { return path_; }

    // One line, handed to the system before this returns, so that a crash loses none. Throws
    // FileError where the line cannot be written, and where a path of the command is not UTF-8,
    // which a script cannot hold. If later commands would then act on something else (part of a
    // line is written, or a model that is opened is missing), the record ends before this command.
    // Does nothing once the record has ended.
    void record(const Command& command);
    // A line that is no command.
    void remark(const std::string& text);
    bool has_ended() const { return has_ended_; }

  private:
    void write_line(const std::string& line);

    std::string path_;
    FileDescriptor file_;
    off_t size_ = 0;  // up to the end of the last whole line
    bool has_ended_ = false;
};

}  // namespace pectin

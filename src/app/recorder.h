// Writes every command, as it is done, into a script whose replay gives the same bytes.
#pragma once

#include <string>

#include "command/command.h"
#include "io/file_descriptor.h"

namespace pectin {

// The first line of every script.
inline constexpr const char* kScriptHeader = "{\"pectin\": 1}";

class Recorder {
  public:
    // Begins a new file at the path. An earlier record there is left alone; this record then gets
    // the first free name beside it (NAME-2, NAME-3, …). Throws FileError, also if the path leads
    // to something other than a record.
    explicit Recorder(const std::string& path);
    // Begins a record in a file that is open and empty.
    Recorder(std::string path, FileDescriptor file);

    const std::string& path() const { return path_; }

    // Writes one line and hands it to the system, so that a crash loses no command.
    // Throws FileError if the line cannot be written, or if a path of the command is not UTF-8,
    // which a script cannot hold. If a replay of later commands would then have another effect
    // (part of a line was written, or the opening of a model is missing), the record ends before
    // this command. Does nothing once the record has ended.
    void record(const Command& command);
    // Writes a line that is not a command.
    void write_comment(const std::string& text);
    bool has_ended() const { return has_ended_; }

  private:
    void write_line(const std::string& line);

    std::string path_;
    FileDescriptor file_;
    off_t size_ = 0;  // length up to the end of the last complete line
    bool has_ended_ = false;
};

}  // namespace pectin

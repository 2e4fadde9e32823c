// Writes every command as it is done, as a script that replays to the same bytes.
#pragma once

#include <string>

#include "command/command.h"
#include "io/file_descriptor.h"

namespace pectin {

class Recorder {
  public:
    // Begins the file anew. Throws FileError.
    explicit Recorder(const std::string& path);

    // One line, handed to the system before this returns, so that a crash loses none. Throws
    // FileError; also where a path of the command is not UTF-8, which a script cannot hold.
    void record(const Command& command);

  private:
    void write_line(const std::string& line);

    std::string path_;
    FileDescriptor file_;
};

}  // namespace pectin

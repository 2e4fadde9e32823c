// The exception for errors in files and with files.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/printable.h"

namespace pectin {

// what() is "PATH:LINE: message", or "PATH: message" if the error is not in a line (line 0). It is
// printable() text, so that a zero byte in a file or a path does not truncate it. Messages say what
// is wrong and, where this helps, what would be right.
class FileError : public std::runtime_error {
  public:
    FileError(std::string path, std::size_t line, std::string message)
        : std::runtime_error(printable(path) + (line == 0 ? "" : ":" + std::to_string(line)) +
                             ": " + printable(message)),
          path_(std::move(path)),
          line_(line),
          message_(printable(message)) {}
    FileError(std::string path, std::string message)
        : FileError(std::move(path), 0, std::move(message)) {}

    const std::string& path() const { return path_; }
    std::size_t line() const { return line_; }  // counted from 1; 0 if there is none
    const std::string& message() const { return message_; }

  private:
    std::string path_;
    std::size_t line_;
    std::string message_;
};

}  // namespace pectin

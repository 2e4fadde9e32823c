// What goes wrong with files, with the place where it did.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/printable.h"

namespace pectin {

// what() is "PATH:LINE: message", or "PATH: message" where no line is to blame (line 0), as
// printable() text: a zero byte in a file or a path does not cut it off. Messages say what is wrong
// and, where that helps, what would be right.
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
    std::size_t line() const { return line_; }  // from 1; 0 where there is none
    const std::string& message() const { return message_; }

  private:
    std::string path_;
    std::size_t line_;
    std::string message_;
};

}  // namespace pectin

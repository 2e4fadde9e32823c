// What goes wrong with files, with the place where it did.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace pectin {

// what() is "PATH:LINE: message", or "PATH: message" where no line is to blame (line 0).
// Messages say what is wrong and, where that helps, what would be right.
class FileError : public std::runtime_error {
  public:
    FileError(std::string path, std::size_t line, std::string message)
        : std::runtime_error(path + (line == 0 ? "" : ":" + std::to_string(line)) + ": " + message),
          path_(std::move(path)),
          line_(line),
          message_(std::move(message)) {}
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

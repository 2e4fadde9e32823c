// A script, line by line: {"pectin": 1}, then one command a line (UTF-8, JSON Lines).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>

#include "command/command.h"
#include "command/json.h"

namespace pectin {

struct ScriptLine {
    std::size_t number;  // from 1
    std::variant<Command, CommandError> command;
};

// Reads one line at a time, so that what stands before a bad line can be done first.
class ScriptReader {
  public:
    // Precondition: `text` outlives the reader.
    explicit ScriptReader(std::istream& text) : text_(text) {}

    // The next command, or the error that takes its place; nothing at the end. Blank lines and
    // lines that start with # are passed over. A bad first line and a read that fails are errors
    // after which there is nothing more.
    std::optional<ScriptLine> next();

  private:
    std::optional<std::string> read_line();
    std::optional<ScriptLine> fail(std::string what);

    std::istream& text_;
    std::size_t number_ = 0;
    bool is_done_ = false;
};

// Relative paths become relative to `folder`; absolute ones, and all where it is empty, stay.
void resolve_paths(Command& command, const std::string& folder);

}  // namespace pectin

// Reads a script: the line {"pectin": 1}, then one command on each line (JSON Lines in UTF-8).
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
    // The text of the lines with # right before it, joined by spaces; a blank line ends a comment.
    std::string comment{};
};

// Reads one line at a time, so that the commands before an invalid line can be executed first.
class ScriptReader {
  public:
    // Precondition: `text` outlives the reader.
    explicit ScriptReader(std::istream& text) : text_(text) {}

    // The next command or the error in its line; nothing at the end of the script. Skips blank
    // lines and lines that start with #. An invalid first line and a read error end the script.
    std::optional<ScriptLine> next();

  private:
    std::optional<std::string> read_line();
    std::optional<ScriptLine> fail(std::string what);

    std::istream& text_;
    std::size_t number_ = 0;
    bool is_done_ = false;
};

// Makes a relative path of the command relative to `folder`. Absolute paths are unchanged; if
// `folder` is empty, all paths are.
void resolve_paths(Command& command, const std::string& folder);

}  // namespace pectin

// Converts commands from and to JSON (the lines of a script), and statistics to JSON.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "command/command.h"
#include "command/result.h"
#include "command/statistics.h"

namespace pectin {

// Why a line is not a valid command.
struct CommandError {
    std::string command;  // the given name, or "script" if the line has none
    std::string what;     // what is wrong and what would be right, in one line
    bool operator==(const CommandError&) const = default;
};

// Reads one line strictly: an unknown, repeated or missing field, a wrong type and a value that can
// never be right are errors. Does not check what depends on the object or on the current settings.
std::variant<Command, CommandError> parse_command(std::string_view json_line);

// Refuses the first line of a script unless it is {"pectin": 1}.
Done check_header(std::string_view json_line);

// Writes the command as one line without a line end. parse_command() reads an equal command from
// it. Numbers are the shortest decimals that read back the same. Precondition: paths are UTF-8,
// numbers are finite, and the budget is at most 2^53.
std::string format_command(const Command& command);

// Whether the text is exactly one JSON value.
bool is_json(std::string_view text);

// The contents of the file that `stats` writes. Numbers that are not finite become null.
std::string format_statistics(const Statistics& statistics);

}  // namespace pectin

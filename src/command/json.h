// Commands and statistics as JSON: the lines of a script, and what `stats` writes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "command/command.h"
#include "command/statistics.h"

namespace pectin {

// Why a line is no command.
struct CommandError {
    std::string command;  // the name given, or "script" where the line names none
    std::string what;     // what is wrong and what would be right, one line
    bool operator==(const CommandError&) const = default;
};

// Reads one line, strictly: an unknown, repeated or missing field, a wrong type and a value that
// can never be right are errors. What depends on the object or on present settings is not
// checked here.
std::variant<Command, CommandError> parse_command(std::string_view json_line);

// What is wrong with the first line of a script; nothing if it is {"pectin": 1}.
std::optional<std::string> check_header(std::string_view json_line);

// One line without its end, which parses back to an equal command; numbers are the shortest that
// read back the same. Precondition: paths are UTF-8, numbers finite and budget at
// most 2^53.
std::string format_command(const Command& command);

// Whether a text is one JSON value and nothing else.
bool is_json(std::string_view text);

// The whole file that `stats` writes; a number that is not finite becomes null.
std::string format_statistics(const Statistics& statistics);

}  // namespace pectin

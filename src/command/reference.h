// The commands of a script in words, from their schema: for help, messages and the README.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pectin {

struct FieldReference {
    std::string name;
    std::string right;                   // what it has to be, such as "a length above 0"
    std::optional<std::string> initial;  // its default as JSON or in words; none: it is required
    std::string meaning;                 // one sentence
    // Of a field that is an object, or a list of objects.
    std::vector<FieldReference> nested{};
};

struct CommandReference {
    std::string name;
    std::string meaning;
    std::vector<FieldReference> fields;
};

// One entry for each alternative of Command, in the same order.
std::span<const CommandReference> command_reference();
// Null if there is no such command.
const CommandReference* find_command(std::string_view name);

// The command and its fields for a terminal of 80 columns; ends with a line end.
std::string help_text(const CommandReference& command);
// All commands as a table in Markdown, as the README has it; ends with a line end.
std::string reference_table();
// A JSON Schema (draft 2020-12) of one line of a script, for editors and generators.
std::string json_schema();

}  // namespace pectin

// The commands of a script with their fields and meanings. Error messages and help use this table.
#pragma once

#include <span>

namespace pectin {

struct FieldReference {
    const char* name;
    const char* meaning;  // default value in parentheses
};

struct CommandReference {
    const char* name;
    const char* meaning;
    std::span<const FieldReference> fields;
};

// One entry for each alternative of Command, in the same order.
std::span<const CommandReference> command_reference();

}  // namespace pectin

// The commands of a script, their fields and what each means: one table for errors and help.
#pragma once

#include <span>
#include <vector>

namespace pectin {

struct FieldReference {
    const char* name;
    const char* meaning;
};

struct CommandReference {
    const char* name;
    const char* meaning;
    std::vector<FieldReference> fields;
};

// One entry an alternative of Command, in its order.
std::span<const CommandReference> command_reference();

}  // namespace pectin

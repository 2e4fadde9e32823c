// Questions about what a command does.
#pragma once

#include <variant>

#include "command/command.h"

namespace pectin {

// Whether the command is one of the given alternatives.
template <typename... Alternatives>
bool is_any_of(const Command& command) {
    return (std::holds_alternative<Alternatives>(command) || ...);
}

// Whether the command replaces the object by another one.
inline bool makes_object(const Command& command) {
    return is_any_of<command::Open, command::Shape>(command);
}

}  // namespace pectin

// Reads the fields of each command. Not installed, like json_values.h.
#pragma once

#include <cstddef>

#include "command/command.h"
#include "command/json_values.h"

namespace pectin::command_json {

// The command that `object` describes. index: that of the command in command_reference(), which is
// also that of the alternative in Command. Throws Problem if a field is missing or its value can
// never be right. Precondition: the object has no field that the reference does not list.
Command read_fields(std::size_t index, const json& object);

}  // namespace pectin::command_json

// Whether the fields of a command are within the limits of its schema.
#pragma once

#include <optional>

#include "command/command.h"
#include "command/result.h"

namespace pectin {

// Refuses a field that can never be right, and fields that contradict each other, whatever the
// object and the settings are. The reason names the field, the limit and the value. Scripts and the
// session ask here, so they refuse the same values with the same words. Cost: O(size of the
// command).
Done check(const Command& command);

}  // namespace pectin

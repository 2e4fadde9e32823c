// Parses a line of JSON strictly. Not installed, like json_values.h.
#pragma once

#include <string_view>

#include "command/json_values.h"

namespace pectin::command_json {

// The value of the text. Throws Problem for text that is not JSON, an object that has a field twice
// and a number that is too large for a double. Cost: O(text).
json parse_strictly(std::string_view text);

}  // namespace pectin::command_json

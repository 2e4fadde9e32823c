// Suggests the command that a misspelt name means.
#pragma once

#include <string_view>

namespace pectin {

// The command whose name is nearest to `given`, if the edit distance is at most 2; otherwise null.
const char* nearest_command(std::string_view given);

}  // namespace pectin

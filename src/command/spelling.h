// Suggests the command that a misspelt name means.
#pragma once

#include <string>
#include <string_view>

namespace pectin {

// Says that the name is that of no command, which one may be meant, if the edit distance is at most
// 2, and which ones there are.
std::string unknown_command(std::string_view given);

}  // namespace pectin

// What a misspelt name was meant to be.
#pragma once

#include <string_view>

namespace pectin {

// The command whose name is within two slips of `given`; nothing if there is none.
const char* nearest_command(std::string_view given);

}  // namespace pectin

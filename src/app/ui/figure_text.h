// Numbers as the panels show them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "app/workspace.h"

namespace pectin {

// Formats 1234567 as 1,234,567.
std::string grouped(std::uint64_t number);
// The number and its noun.
std::string counted(std::uint64_t number, const char* one, const char* many);
// format: of printf, for one double; the text has at most 47 characters.
std::string formatted(const char* format, double value);
// Formats a number of bytes with as many digits as are useful.
std::string megabytes(std::size_t bytes);
// The memory that the undo history uses, and its limit.
std::string undo_memory(const ObjectFigures& object);

}  // namespace pectin

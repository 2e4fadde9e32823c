// Whole files into memory.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "io/progress.h"

namespace pectin {

// The bytes of the file at `path`.
// Throws FileError: open_file's, and where it is larger than `most_bytes`, before it takes memory
// for them. Throws Cancelled.
std::string read_whole_file(const std::string& path, const Progress& progress = {},
                            std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

}  // namespace pectin

// Reads whole files into memory.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "io/open_file.h"
#include "io/progress.h"

namespace pectin {

// The bytes of the file at `path`. Throws FileError as FileAccess does, and if the file is larger
// than `max_bytes`, before allocating memory for it. Throws Cancelled, also while the file system
// does not answer.
std::string read_whole_file(const std::string& path, const Progress& progress = {},
                            std::size_t max_bytes = std::numeric_limits<std::size_t>::max(),
                            const FileOptions& options = {});

}  // namespace pectin

// Whole files into memory.
#pragma once

#include <string>

namespace pectin {

// The bytes of the file at `path`.
// Throws FileError where it is missing, unreadable, a folder or a device.
std::string read_whole_file(const std::string& path);

}  // namespace pectin

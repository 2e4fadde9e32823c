// Fingerprints of files, which tell whether a file still has the same contents.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "io/progress.h"

namespace pectin {

// Returns the length and a 64-bit hash of the file's contents as one word. It is not meant to
// withstand an attacker.
// consume: if set, it is called with the contents, in order and in parts of at most 1 MiB.
// Throws FileError if the file cannot be read, Cancelled, and whatever consume throws.
// Cost: O(size); a gigabyte takes about a second or less.
std::string fingerprint(const std::string& path, const Progress& progress = {},
                        const std::function<void(std::string_view)>& consume = {});

}  // namespace pectin

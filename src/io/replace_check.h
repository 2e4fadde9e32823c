// Keeps results from replacing files of another kind by mistake.
#pragma once

#include <string>
#include <string_view>

#include "io/file_kind.h"

namespace pectin {

// Whether a file with these contents may be replaced. kind: the result of recognise_file().
using MayReplace = bool (*)(const FileKind& kind, std::string_view contents);

// Throws FileError if the file at `path` must not be replaced. A file may be replaced if it does
// not exist, is empty, or `may_replace` accepts it. Anything but a regular file is also accepted;
// the writer refuses it. writes: for the message, which also says what the file is: "stats writes
// JSON files".
void check_may_replace(const std::string& path, MayReplace may_replace, std::string_view writes);

bool is_png(const FileKind& kind, std::string_view contents);

}  // namespace pectin

// Guards files against results that would replace them by a slip of the hand.
#pragma once

#include <string>
#include <string_view>

#include "io/file_kind.h"

namespace pectin {

// Whether a file with these contents may be replaced. kind: as recognise_file() has it.
using MayReplace = bool (*)(const FileKind& kind, std::string_view contents);

// Throws FileError unless there is no file at `path`, an empty one, or one that `may_replace`
// accepts. The message says what the file is. writes: "stats writes JSON files", for the message.
// What is no regular file is left to the writer, which refuses it.
void check_may_replace(const std::string& path, MayReplace may_replace, std::string_view writes);

bool is_png(const FileKind& kind, std::string_view contents);

}  // namespace pectin

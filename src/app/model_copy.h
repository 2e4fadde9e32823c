// Copies of opened models for recovery: a session can be restored only from the very model that it
// has opened, and a save may replace that.
#pragma once

#include <string>

#include "command/command.h"
#include "io/progress.h"
#include "session/model_file.h"

namespace pectin {

// Tells the contents of a file from others by their size and a 64-bit hash. A plain word. Not made
// to withstand an attacker. Throws FileError, Cancelled. Cost: O(size), a gigabyte a second or
// more.
std::string fingerprint(const std::string& path, const Progress& progress = {});

struct ModelCopy {
    std::string from, to;
    std::string fingerprint;  // of what `from` held when it was opened
};

// Makes the copy, whole and flushed to the disk or not at all. Throws FileError, also where the
// file has other contents by now; Cancelled.
void make_copy(const ModelCopy& copy, const Progress& progress = {});

// Loads what `open` has loaded in an earlier session: from the copy, where that exists, or else
// from the file itself. The result is the same, whichever it comes from; material files are looked
// for beside the original. Throws FileError where neither holds the contents of that time, and what
// load_model() throws.
LoadedModel load_original(const command::Open& open, const ModelCopy& copy,
                          const Progress& progress = {});

}  // namespace pectin

// Copies of opened models for recovery. A session can be restored only from the very model that it
// opened, and a save may replace that model.
#pragma once

#include <string>

#include "command/command.h"
#include "io/progress.h"
#include "session/model_file.h"

namespace pectin {

struct ModelCopy {
    std::string from, to;
    std::string fingerprint;  // of the contents that `from` had when it was opened
};

// Makes the copy and flushes it to the disk. If it fails, no copy is left.
// Throws FileError, also if the file's contents do not match the fingerprint, and Cancelled.
void make_copy(const ModelCopy& copy, const Progress& progress = {});

// Loads the model that `open` loaded in an earlier session. It is read from copy.from if that file
// exists, or else from open.path; the result is the same. Material files are looked for beside
// open.path. If the model is read from the copy and copy.to is not empty, copy.to becomes another
// copy.
// Throws FileError if neither file has the contents of that time, and whatever load_model() throws.
LoadedModel load_original(const command::Open& open, const ModelCopy& copy,
                          const Progress& progress = {});

}  // namespace pectin

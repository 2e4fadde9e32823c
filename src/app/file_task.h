// Reading and writing of models in the background.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/background_task.h"
#include "app/model_copy.h"
#include "session/session.h"

namespace pectin {

struct FileResult {
    std::optional<LoadedModel> model{};  // the model that was read
    std::string fingerprint{};           // of the model's file; empty if it was not asked for
    // Whether the model's file has the contents that were read.
    bool is_in_file = true;
    SaveReport report{};    // about the file that was written
    std::string warning{};  // that the session cannot be restored after a crash
};

using FileWork = std::function<FileResult(const Progress&)>;

// A command that reads or writes a file, and the work on that file.
struct FileTask {
    FileTask(Command begun, FileWork how) : command(std::move(begun)), work(std::move(how)) {}

    Command command;  // open or save
    BackgroundTask<FileResult> work;
};

// The work of each command. It throws FileError if a file cannot be read or written, and Cancelled.

// Reads a model. with_fingerprint: whether the result also holds the fingerprint of its file.
FileWork open_work(const command::Open& open, bool with_fingerprint);
// Reads a model with the contents that it had in an earlier session, as load_original() does.
FileWork reopen_work(const command::Open& open, const ModelCopy& copy);
// Makes the copies and then saves the session's mesh. The session must not change before the work
// has ended.
FileWork save_work(const command::Save& save, std::vector<ModelCopy> copies,
                   const Session& session);

}  // namespace pectin

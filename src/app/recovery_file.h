// Keeps the commands of a window, so that its session can be restored after a crash or a signal.
//
// Each window writes its commands, as they are done, to a file of its own in the state folder and
// holds a lock on that file. A window that is closed removes its file. A file without a lock
// therefore belongs to a session that ended unexpectedly, and the next window offers to restore it.
//
// The commands act on the model as it was when it was opened. The file therefore notes the
// fingerprint of each model, and before a save replaces a model, a copy of it is put beside the
// file.
#pragma once

#include <string>
#include <vector>

#include "app/model_copy.h"
#include "app/recorder.h"
#include "command/command.h"

namespace pectin {

class RecoveryFile {
  public:
    // Creates a locked file in the folder, and the folder if it does not exist. Throws FileError.
    explicit RecoveryFile(const std::string& folder);
    // The destructor does not remove the file: only remove() says that the session ended normally.
    ~RecoveryFile() = default;
    RecoveryFile(RecoveryFile&&) = default;
    RecoveryFile& operator=(RecoveryFile&&) = default;

    const std::string& path() const { return recorder_.path(); }
    // Appends the command if restoring needs it.
    // fingerprint: of the model, if the command opens one; empty if it is not known.
    // Throws FileError if the command cannot be written. The file then keeps the earlier commands,
    // and later calls do nothing.
    void record(const Command& command, const std::string& fingerprint = {});
    bool has_failed() const { return has_failed_; }
    // The copies to make before a file is saved at this path, namely of the models that it
    // replaces.
    std::vector<ModelCopy> copies_before_save(const std::string& path) const;
    // The path for the copy of a model with this fingerprint.
    std::string copy_path(const std::string& model, const std::string& fingerprint) const;
    // Removes the file and the copies.
    void remove();

  private:
    Recorder recorder_;
    std::vector<ModelCopy> opened_;  // the models that have been opened, with where to copy them
    bool has_failed_ = false;
};

// Whether restoring a session executes this command again. This holds for all commands that affect
// the object and for none that writes a file.
bool is_restored(const Command& command);

}  // namespace pectin

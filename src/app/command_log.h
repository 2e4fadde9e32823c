// The files to which a window writes its commands: the record that the user asked for, and the
// recovery file.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/messages.h"
#include "app/recorder.h"
#include "app/recovery_file.h"

namespace pectin {

// If a file cannot be written, the log adds a notice to the messages and goes on without it.
class CommandLog {
  public:
    explicit CommandLog(std::optional<Recorder> recorder) : recorder_(std::move(recorder)) {}

    // The path of the record; empty if nothing is recorded.
    std::string record_path() const { return recorder_ ? recorder_->path() : ""; }

    // Begins a recovery file in this folder.
    void begin_recovery(const std::string& folder, Messages& messages);
    // Removes the recovery file, since the session has ended normally.
    void end_recovery();
    // Whether there is a recovery file that holds all commands since begin_recovery().
    bool has_recovery() const { return recovery_ && !recovery_->has_failed(); }
    // As RecoveryFile::copies_before_save(); empty without recovery.
    std::vector<ModelCopy> copies_before_save(const std::string& path) const;
    // As RecoveryFile::copy_path(); empty without recovery.
    std::string copy_path(const std::string& model, const std::string& fingerprint) const;

    // Writes the command to both files.
    // fingerprint: of the model, if the command opens one; empty if it is not known.
    void record(const Command& command, const std::string& fingerprint, Messages& messages);
    void record_for_recovery(const Command& command, const std::string& fingerprint,
                             Messages& messages);

  private:
    std::optional<Recorder> recorder_;
    std::optional<RecoveryFile> recovery_;
};

}  // namespace pectin

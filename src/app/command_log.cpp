#include "app/command_log.h"

#include <algorithm>
#include <exception>

#include "app/words.h"
#include "io/file_error.h"

namespace pectin {
namespace {

// Why a file for recovery cannot be written. The user has not chosen its name, so it is not said.
std::string reason_of(const std::exception& error) {
    const auto* const file_error = dynamic_cast<const FileError*>(&error);
    std::string reason = file_error ? file_error->message() : error.what();
    reason.resize(std::min(reason.find(';'), reason.size()));  // without what follows from it
    return sentences("x" + reason).substr(1);
}

}  // namespace

void CommandLog::begin_recovery(const std::string& folder, Messages& messages) {
    try {
        recovery_.emplace(folder);
    } catch (const std::exception& error) {
        messages.add_notice(
            "This session cannot be restored after a crash, because the folder for recovery "
            "files " +
            reason_of(error));
    }
}

void CommandLog::end_recovery() {
    if (recovery_) recovery_->remove();
    recovery_.reset();
}

std::vector<ModelCopy> CommandLog::copies_before_save(const std::string& path) const {
    return recovery_ ? recovery_->copies_before_save(path) : std::vector<ModelCopy>();
}

std::string CommandLog::copy_path(const std::string& model, const std::string& fingerprint) const {
    return has_recovery() ? recovery_->copy_path(model, fingerprint) : "";
}

void CommandLog::record(const Command& command, const std::string& fingerprint,
                        Messages& messages) {
    try {
        if (recorder_) recorder_->record(command);
    } catch (const std::exception& error) {
        messages.add_notice(words_of(error));
    }
    record_for_recovery(command, fingerprint, messages);
}

void CommandLog::record_for_recovery(const Command& command, const std::string& fingerprint,
                                     Messages& messages) {
    try {
        if (recovery_) recovery_->record(command, fingerprint);
    } catch (const std::exception& error) {
        messages.add_notice(
            "From now on, changes cannot be restored after a crash, because the recovery file " +
            reason_of(error));
    }
}

}  // namespace pectin

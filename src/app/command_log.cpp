#include "app/command_log.h"

#include <exception>

namespace pectin {

void CommandLog::begin_recovery(const std::string& folder, Messages& messages) {
    try {
        recovery_.emplace(folder);
    } catch (const std::exception& error) {
        messages.add_notice(error.what());
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
        messages.add_notice(error.what());
    }
    record_for_recovery(command, fingerprint, messages);
}

void CommandLog::record_for_recovery(const Command& command, const std::string& fingerprint,
                                     Messages& messages) {
    try {
        if (recovery_) recovery_->record(command, fingerprint);
    } catch (const std::exception& error) {
        messages.add_notice(std::string("From now on, changes cannot be restored after a crash: ") +
                            error.what());
    }
}

}  // namespace pectin

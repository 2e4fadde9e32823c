#include "app/messages.h"

#include "io/printable.h"

namespace pectin {

void Messages::set(const std::string& message, Kind kind) {
    command_message_ = printable(message);
    command_kind_ = kind;
}

void Messages::add_notice(const std::string& message) {
    notices_ += (notices_.empty() ? "" : "\n") + printable(message);
}

std::string Messages::text() const {
    const bool are_both = !notices_.empty() && !command_message_.empty();
    return notices_ + (are_both ? "\n" : "") + command_message_;
}

bool Messages::is_confirmation() const {
    return notices_.empty() && !command_message_.empty() && command_kind_ == Kind::confirmation;
}

bool Messages::has_warning() const {
    return !notices_.empty() || (!command_message_.empty() && command_kind_ == Kind::warning);
}

void Messages::dismiss() {
    command_message_.clear();
    notices_.clear();
}

}  // namespace pectin

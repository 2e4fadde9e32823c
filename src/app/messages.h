// What the window tells the user, as printable() text.
#pragma once

#include <string>

namespace pectin {

class Messages {
  public:
    // A warning says that something went wrong, or otherwise than expected. An information is
    // worth knowing and nothing is wrong. A confirmation says that what the user wanted is done.
    enum class Kind { warning, information, confirmation };
    // Replaces the message about the last command. It is shown until the next command is done or
    // the next drag begins.
    void set(const std::string& message, Kind kind = Kind::warning);
    const std::string& command_message() const { return command_message_; }
    Kind command_kind() const { return command_kind_; }
    void clear_command_message() { command_message_.clear(); }

    // Adds a warning that is shown until dismiss().
    void add_notice(const std::string& message);

    // All messages, one per line.
    std::string text() const;
    // Whether the text is a confirmation and contains no warning.
    bool is_confirmation() const;
    // Whether any of the messages is a warning.
    bool has_warning() const;
    void dismiss();

  private:
    std::string command_message_, notices_;
    Kind command_kind_ = Kind::warning;
};

}  // namespace pectin

// What the window tells the user, as printable() text.
#pragma once

#include <string>

namespace pectin {

class Messages {
  public:
    // Replaces the message about the last command. It is shown until the next command is done or
    // the next drag begins.
    void set(const std::string& message);
    const std::string& command_message() const { return command_message_; }
    void clear_command_message() { command_message_.clear(); }

    // Adds a message that is shown until dismiss().
    void add_notice(const std::string& message);

    // All messages, one per line.
    std::string text() const;
    void dismiss();

  private:
    std::string command_message_, notices_;
};

// Makes a sentence of a remark that begins with a small letter and has no full stop.
std::string sentence(std::string remark);

}  // namespace pectin

// Executes a script without a window.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <mutex>
#include <string>

namespace pectin {

// How far a replay has come. Its members may be called from any thread.
class ReplayStatus {
  public:
    void begin(std::string title, std::size_t line, std::string command);
    // Ends the command that was begun last.
    void finish();
    // The message for the case that this signal ends the replay now. It has the form of an error.
    std::string exit_message(const std::string& signal) const;

  private:
    mutable std::mutex mutex_;
    std::string title_, command_;  // command_ is empty between two commands
    std::size_t line_ = 0, done_ = 0;
};

// Executes the script at this path; "-" means standard input. Stops at the first command that fails
// and writes SCRIPT:LINE: COMMAND: what is wrong and what would be right to `errors`.
// Returns whether everything was done.
bool replay(const std::string& script_path, std::ostream& errors, ReplayStatus& status);

}  // namespace pectin

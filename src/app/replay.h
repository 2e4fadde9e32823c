// Does what a script says, without a window.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <mutex>
#include <string>

namespace pectin {

// How far a replay has come. Safe to use on any thread.
class ReplayStatus {
  public:
    void begin(std::string title, std::size_t line, std::string command);
    void finish();  // the command that was begun last
    // What to say if the signal of this name ends the replay here, headed as errors are.
    std::string farewell(const std::string& signal) const;

  private:
    mutable std::mutex mutex_;
    std::string title_, command_;  // the command is empty between two commands
    std::size_t line_ = 0, done_ = 0;
};

// Returns whether all of it was done. Stops at the first command that fails and writes to
// `errors` SCRIPT:LINE: command: what is wrong and what would be right. "-" reads standard input.
bool replay(const std::string& script_path, std::ostream& errors, ReplayStatus& status);

}  // namespace pectin

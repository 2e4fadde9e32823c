// Other programs, run beside the test.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pectin {

// How long a condition may take to come true: only a failure has to wait for so long, and a machine
// that does much else is slow.
inline constexpr std::chrono::milliseconds kPatience = std::chrono::seconds(90);

using Environment = std::vector<std::pair<std::string, std::string>>;  // empty value: not set

// A program that is ended with this, at the latest.
class Process {
  public:
    // Its error output goes to the file `errors`, and it reads from the file or pipe `input`.
    Process(const std::vector<std::string>& words, const Environment& environment,
            const std::string& errors = "/dev/null", const std::string& input = "/dev/null");
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Its exit status; -1 where a signal ended it, none where it has not ended in time.
    std::optional<int> wait(std::chrono::milliseconds most = kPatience);
    // Stops it where it is, and lets it go on: between the two everything waits to be handled.
    void pause() const;
    void resume() const;
    void signal(int number) const;

  private:
    pid_t id_ = -1;
    std::optional<int> status_;
};

// Whether it came true within a while.
bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds most = kPatience);

}  // namespace pectin

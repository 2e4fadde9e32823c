// Starts other programs and controls them.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pectin {

// The time that a condition may take to become true. It is long, because a busy machine is slow and
// only a failing test waits for all of it.
inline constexpr std::chrono::milliseconds kPatience = std::chrono::seconds(90);

using Environment = std::vector<std::pair<std::string, std::string>>;  // empty value: not set

// A running program. The destructor kills it.
class Process {
  public:
    // Standard error is written to the file `errors`; standard input is the file or pipe `input`.
    Process(const std::vector<std::string>& words, const Environment& environment,
            const std::string& errors = "/dev/null", const std::string& input = "/dev/null");
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // The exit status; -1 if a signal ended the program, none if it has not ended in time.
    std::optional<int> wait(std::chrono::milliseconds most = kPatience);
    // Suspends and resumes the program. In between, its input and signals are queued.
    void pause() const;
    void resume() const;
    void signal(int number) const;
    // The time that all its threads have been running for so far.
    std::chrono::milliseconds cpu_time() const;

  private:
    pid_t id_ = -1;
    std::optional<int> status_;
};

// Waits for the condition; returns whether it became true in time.
bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds most = kPatience);

}  // namespace pectin

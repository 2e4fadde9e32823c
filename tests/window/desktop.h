// A display in memory with the program's window on it, and a hand on its mouse and keyboard.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pectin {

using Environment = std::vector<std::pair<std::string, std::string>>;  // empty value: not set

// A program that is ended with this, at the latest.
class Process {
  public:
    // Its error output goes to the file `errors`.
    Process(const std::vector<std::string>& words, const Environment& environment,
            const std::string& errors = "/dev/null");
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Its exit status; -1 where a signal ended it, none where it has not ended in time.
    std::optional<int> wait(std::chrono::milliseconds most);

  private:
    pid_t id_ = -1;
    std::optional<int> status_;
};

// Whether it came true within a while.
bool eventually(const std::function<bool()>& condition,
                std::chrono::milliseconds most = std::chrono::seconds(20));

// Why the window cannot be tested here; empty where it can.
std::string missing_for_windows();

// Xvfb on a free number.
class Desktop {
  public:
    Desktop();
    const Environment& environment() const { return environment_; }
    bool is_running() const { return !environment_.empty(); }

    // --- What a hand does, each followed by a moment for the program to answer.
    void move(int x, int y) const;
    void press(int button = 1) const;
    void release(int button = 1) const;
    void key(const std::string& name) const;  // as xdotool calls it: "ctrl+z"
    void hold(const std::string& name) const;
    void let_go(const std::string& name) const;
    void type(const std::string& text) const;
    void drag(int from_x, int from_y, int to_x, int to_y) const;
    bool drop(const std::string& path) const;  // a file on the window; whether it was taken
    void wait_for_dialog() const;              // to come, to go or to show another folder
    // Until the program's window is on the display.
    bool shows_window() const;

  private:
    int xdotool(const std::vector<std::string>& words) const;
    std::optional<Process> server_;
    Environment environment_;
};

}  // namespace pectin

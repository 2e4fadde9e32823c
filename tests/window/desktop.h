// A display in memory with the program's window on it, and a hand on its mouse and keyboard.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pectin {

// How long a condition may take to come true: only a failure has to wait for so long, and a machine
// that does much else is slow.
inline constexpr std::chrono::milliseconds kPatience = std::chrono::seconds(90);

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
    std::optional<int> wait(std::chrono::milliseconds most = kPatience);
    // Stops it where it is, and lets it go on: between the two everything waits to be handled.
    void pause() const;
    void resume() const;

  private:
    pid_t id_ = -1;
    std::optional<int> status_;
};

// Whether it came true within a while.
bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds most = kPatience);

// Why the window cannot be tested here; empty where it can.
std::string missing_for_windows();

// Xvfb on a free number.
class Desktop {
  public:
    Desktop();
    const Environment& environment() const { return environment_; }
    bool is_running() const { return !environment_.empty(); }

    // --- What a hand does. The program handles it in this order, however slow it is, so nothing has
    // to be waited for between two of these.
    void move(int x, int y) const;
    void press(int button = 1) const;
    void release(int button = 1) const;
    void key(const std::string& name) const;  // as xdotool calls it: "ctrl+z"
    void hold(const std::string& name) const;
    void let_go(const std::string& name) const;
    void type(const std::string& text) const;
    void drag(int from_x, int from_y, int to_x, int to_y) const;
    bool drop(const std::string& path) const;  // a file on the window; whether it was taken
    // Until the program's window is on the display.
    bool shows_window() const;

  private:
    int xdotool(const std::vector<std::string>& words) const;
    std::optional<Process> server_;
    Environment environment_;
};

}  // namespace pectin

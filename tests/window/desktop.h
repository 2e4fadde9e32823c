// A display in memory with the program's window on it, and a hand on its mouse and keyboard.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "support/process.h"

namespace pectin {

// Why the window cannot be tested here; empty where it can.
std::string missing_for_windows();

// Xvfb on a free number.
class Desktop {
  public:
    Desktop();
    const Environment& environment() const { return environment_; }
    bool is_running() const { return !environment_.empty(); }

    // --- What a hand does. The program handles it in this order, however slow it is, so nothing
    // has to be waited for between two of these.
    void move(int x, int y) const;
    void press(int button = 1) const;
    void release(int button = 1) const;
    void key(const std::string& name) const;  // as xdotool calls it: "ctrl+z"
    void hold(const std::string& name) const;
    void release_key(const std::string& name) const;
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

// A virtual display with the program's window on it, and simulated mouse and keyboard input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "support/process.h"

namespace pectin {

// Why the window cannot be tested here; empty if it can.
std::string missing_for_windows();

// An Xvfb display with a free number.
class Desktop {
  public:
    Desktop();
    const Environment& environment() const { return environment_; }
    bool is_running() const { return !environment_.empty(); }

    // --- Input. However slow the program is, it handles the input in this order, so a test need
    // not wait in between.
    void move(int x, int y) const;
    void press(int button = 1) const;
    void release(int button = 1) const;
    void key(const std::string& name) const;  // its name for xdotool, such as "ctrl+z"
    void hold(const std::string& name) const;
    void release_key(const std::string& name) const;
    void type(const std::string& text) const;
    void drag(int from_x, int from_y, int to_x, int to_y) const;
    // Several steps of xdotool at once, such as {"mousemove", "10", "20", "click", "1"}, which take
    // less time than one after the other.
    void perform(const std::vector<std::string>& words) const { xdotool(words); }
    bool drop(const std::string& path) const;  // drops a file; returns whether the window took it
    // A digest of the pixels in this part of the screen.
    std::string screen_digest(int left, int top, int right, int bottom) const;
    // Waits until the program's window is on the display.
    bool shows_window() const;

  private:
    int xdotool(const std::vector<std::string>& words) const;
    std::optional<Process> server_;
    Environment environment_;
};

}  // namespace pectin

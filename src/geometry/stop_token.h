// Tells long work when to stop before it is done.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <utility>

namespace pectin {

// Thrown by long work that was asked to stop and has nothing to return before it is done.
class Stopped : public std::exception {
  public:
    const char* what() const noexcept override { return "stopped"; }
};

// Long work asks it from time to time, on the thread that began the work, and stops where what it
// works on is valid. A default token never asks for that.
class StopToken {
  public:
    StopToken() = default;
    explicit StopToken(std::function<bool()> asked) : asked_(std::move(asked)) {}
    // Asks to stop once this much time has passed.
    static StopToken after(std::chrono::steady_clock::duration time) {
        const auto end = std::chrono::steady_clock::now() + time;
        return StopToken([end] { return std::chrono::steady_clock::now() >= end; });
    }

    bool stop_requested() const { return asked_ && asked_(); }
    void throw_if_requested() const {
        if (stop_requested()) throw Stopped();
    }

  private:
    std::function<bool()> asked_;
};

}  // namespace pectin

// Plays an example step by step on the object of the window. The user goes on step by step or lets
// it play, and may turn the view and sculpt in between.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/example.h"
#include "app/example_motion.h"
#include "app/tool_context.h"

namespace pectin {

// Drags are shown as motions and then executed as they stand in the script. So an example leaves
// the object that a replay of its script gives.
class ExamplePlayer {
  public:
    using Clock = std::chrono::steady_clock;
    // Executes a command; returns whether it is already done. It may go on in the background.
    using Execute = std::function<bool(const Command&)>;

    // The context must outlive the player.
    ExamplePlayer(ToolContext& context, Execute execute)
        : context_(context), execute_(std::move(execute)) {}

    // Resets the settings that drags depend on, and shows the first step. Another example is
    // stopped. Precondition: there is a step, and no tool is active.
    void begin(std::string title, std::vector<ExampleStep> steps);
    // Ends the example. A motion ends where it is, and the object stays as it is.
    void stop();

    // Shows the next step. If one is being shown, it ends at once.
    void next();
    // Shows the following steps one after the other, with time to read their captions.
    void play();
    void pause() { plays_ = false; }
    // Takes a motion back, because something has failed. The example stays open.
    void cancel() noexcept;
    // Ends a motion where it is, because the user does something else. The example stays open.
    void interrupt();

    // To be called once per frame while no tool is active and no dialog is open.
    void advance(Clock::time_point now);
    // Whether advance() has something to do now, though there is no input.
    bool needs_frame(Clock::time_point now) const;
    // A command was done. If it made another object than the example's, the example ends.
    void command_done(const Command& command);
    // The end of an interrupted motion was worked on in the background and has ended.
    void finish();

    // --- State to display.
    bool is_open() const { return !steps_.empty(); }
    bool is_moving() const { return motion_.is_active(); }
    bool plays() const { return plays_; }
    bool is_at_end() const { return !is_running_ && step_ + 1 == steps_.size(); }
    const std::string& title() const { return title_; }
    // Preconditions: is_open().
    const std::string& caption() const { return steps_[step_].caption; }
    std::size_t step() const { return step_; }  // from 0
    const std::vector<ExampleStep>& steps() const { return steps_; }
    void overlay(Overlay& overlay) const;

  private:
    void begin_step(std::size_t step);
    void end_step(Clock::time_point now);
    void begin_command(Clock::time_point now);
    void continue_motion(Clock::time_point now);
    void execute(const Command& command);
    void give_up() noexcept;

    ToolContext& context_;
    Execute execute_;
    std::string title_;
    std::vector<ExampleStep> steps_;
    std::size_t step_ = 0, command_ = 0;  // that is being shown
    bool is_running_ = false;             // whether the step is being shown
    bool hurries_ = false;                // whether it ends without motions
    bool plays_ = false;
    Clock::time_point step_begin_{}, next_step_at_{};  // while it plays
    ExampleMotion motion_;
    Clock::time_point motion_begin_{};
    bool executes_ = false;  // during execute_()
    bool waits_ = false;     // for a command in the background
    bool was_done_ = false;  // the last command
};

}  // namespace pectin

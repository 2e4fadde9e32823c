#include "app/example_player.h"

#include <algorithm>
#include <utility>

#include "app/command_kind.h"
#include "app/default_settings.h"
#include "app/rounded_numbers.h"

namespace pectin {
namespace {

using namespace std::chrono_literals;

constexpr auto kMotionTime = 900ms;
// How long a step is shown at least while the example plays, so that its caption can be read.
constexpr auto kStepTime = 1500ms, kStepTimePerCharacter = 40ms;
// How long its result is shown.
constexpr auto kResultTime = 700ms;

// The part of the way after this part of the time: slow at both ends.
double eased(double part) { return part * part * (3.0 - 2.0 * part); }

// The settings that a replay of the script begins with, except for the history's limit.
std::vector<Command> first_settings() {
    std::vector<Command> settings = default_settings();
    std::erase_if(settings,
                  [](const Command& command) { return is_any_of<command::History>(command); });
    return settings;
}

}  // namespace

void ExamplePlayer::begin(std::string title, std::vector<ExampleStep> steps) {
    stop();
    title_ = std::move(title);
    steps_ = std::move(steps);
    const std::vector<Command> settings = first_settings();
    auto& commands = steps_.front().commands;
    commands.insert(commands.begin(), settings.begin(), settings.end());
    begin_step(0);
    advance(Clock::now());
}

void ExamplePlayer::stop() {
    interrupt();
    steps_.clear();
}

void ExamplePlayer::interrupt() {
    is_running_ = plays_ = waits_ = false;
    if (!motion_.is_active()) return;
    motion_.end();
    if (context_.workspace().end_drag() != Workspace::Outcome::in_progress) finish();
}

void ExamplePlayer::cancel() noexcept {
    give_up();
    if (!motion_.is_active()) return;
    motion_.end();
    if (context_.session().is_dragging()) context_.workspace().session().cancel_drag();
}

void ExamplePlayer::finish() {
    // If the end has failed, the session may still have the drag.
    if (context_.session().is_dragging()) context_.workspace().session().cancel_drag();
    context_.drag_figures().reset_drag();
}

void ExamplePlayer::next() {
    if (is_running_) {
        hurries_ = true;
    } else if (is_open() && !is_at_end()) {
        begin_step(step_ + 1);
    }
}

void ExamplePlayer::play() {
    if (!is_open() || is_at_end()) return;
    plays_ = true;
    next_step_at_ = {};
}

void ExamplePlayer::begin_step(std::size_t step) {
    step_ = step;
    command_ = 0;
    is_running_ = true;
    hurries_ = false;
}

void ExamplePlayer::end_step(Clock::time_point now) {
    is_running_ = false;
    if (is_at_end()) {
        plays_ = false;
        return;
    }
    const auto characters = static_cast<int>(caption().size());
    next_step_at_ =
        std::max(now + kResultTime, step_begin_ + kStepTime + characters * kStepTimePerCharacter);
}

bool ExamplePlayer::needs_frame(Clock::time_point now) const {
    return is_open() && (is_running_ || (plays_ && now >= next_step_at_));
}

void ExamplePlayer::advance(Clock::time_point now) {
    if (!is_open() || context_.is_working()) return;
    if (std::exchange(waits_, false)) {
        if (!was_done_) return give_up();
        ++command_;
    }
    if (!is_running_ && plays_ && now >= next_step_at_) begin_step(step_ + 1);
    if (is_running_ && command_ == 0 && !motion_.is_active()) step_begin_ = now;
    while (is_running_ && !waits_) {
        if (motion_.is_active()) {
            continue_motion(now);
        } else if (command_ == steps_[step_].commands.size()) {
            end_step(now);
        } else {
            begin_command(now);
        }
        if (motion_.is_active()) return;
    }
}

void ExamplePlayer::begin_command(Clock::time_point now) {
    const Command& command = steps_[step_].commands[command_];
    if (hurries_ || !is_motion(command)) return execute(command);
    Workspace& workspace = context_.workspace();
    if (const Done done = motion_.begin(workspace.session(), command); !done) {
        workspace.set_message(rounded_numbers(done.refusal().reason));
        return give_up();
    }
    motion_begin_ = now;
    context_.drag_figures().reset_drag();
}

void ExamplePlayer::continue_motion(Clock::time_point now) {
    const double part = std::chrono::duration<double>(now - motion_begin_) / kMotionTime;
    Session& session = context_.workspace().session();
    if (part < 1.0 && !hurries_) {
        context_.workspace().limit_frame_time(true);
        // A frame that is refused is left out; the command itself says what is wrong.
        if (motion_.move_to(session, eased(std::max(part, 0.0)))) {
            context_.drag_figures().record(session.last_frame(), Clock::now() - now);
        }
        return;
    }
    const Command command = motion_.command();
    motion_.end();
    session.cancel_drag();
    execute(command);
}

void ExamplePlayer::execute(const Command& command) {
    was_done_ = false;
    executes_ = true;
    const bool is_done = execute_(command);
    executes_ = false;
    if (is_done) {
        ++command_;
        if (is_any_of<command::Cage>(command)) context_.display.lattice = true;
    } else if (context_.is_working()) {
        waits_ = true;
    } else {
        give_up();
    }
}

// Stays at this step, because one of its commands cannot be done.
void ExamplePlayer::give_up() noexcept { is_running_ = plays_ = waits_ = false; }

void ExamplePlayer::command_done(const Command& command) {
    was_done_ = true;
    if (makes_object(command) && !executes_) stop();
}

void ExamplePlayer::overlay(Overlay& overlay) const {
    if (!context_.is_working()) motion_.overlay(context_.session(), overlay);
}

}  // namespace pectin

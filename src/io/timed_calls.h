// Runs calls of the system that may never return.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "io/progress.h"

namespace pectin {

// A file system may never answer, for instance if its server is gone. So another thread makes the
// call, while the caller waits until the progress asks to stop or the time is over. The other
// thread then stays until the system answers, even beyond the life of this object. If no thread can
// be created, the caller's thread makes the call.
class TimedCalls {
  public:
    // timeout: how long a call may take without progress.
    explicit TimedCalls(std::chrono::milliseconds timeout) : timeout_(timeout) {}
    ~TimedCalls();
    TimedCalls(const TimedCalls&) = delete;
    TimedCalls& operator=(const TimedCalls&) = delete;

    // Returns whether the call has returned. If it has not, no later call is made, and run()
    // returns false at once, so that many files take no longer than one. Throws what the call
    // throws, and Cancelled.
    //
    // call: has to own everything that it uses, because it may go on when run() has returned.
    // fraction: how much of the call is done, from 0 to 1. It is reported as progress, and while it
    // changes the time starts again.
    bool run(
        std::function<void()> call, const Progress& progress,
        const std::function<double()>& fraction = [] { return 0.0; });

  private:
    struct Worker;
    bool start();

    std::chrono::milliseconds timeout_;
    std::shared_ptr<Worker> worker_;  // shared with the other thread, which may outlive this
    bool is_waiting_ = false;         // whether a call has not returned
};

}  // namespace pectin

// Work on a thread of its own, so that the window goes on meanwhile.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include "io/progress.h"

namespace pectin {

// Begins with its making; its end waits for that of the work, which is asked to stop. Whatever the
// work looks at must stay as it is until then. All members are for the thread that made it.
template <typename Result>
class BackgroundTask {
  public:
    // work: called once, with a Progress that it advances often. Where the system allows no further
    // thread it is done here, before the constructor returns.
    explicit BackgroundTask(std::function<Result(const Progress&)> work) {
        auto task = std::make_shared<std::packaged_task<Result(const Progress&)>>(std::move(work));
        result_ = task->get_future();
        const auto run = [this, task](std::stop_token stop) {
            (*task)(Progress(std::move(stop), [this](double fraction) { fraction_ = fraction; }));
        };
        try {
            thread_ = std::jthread(run);
        } catch (const std::system_error&) {
            run({});
        }
    }
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    // How far the work has come, from 0 to 1.
    double fraction() const { return fraction_; }

    // Asks the work to stop; it does so soon.
    void cancel() { thread_.request_stop(); }
    bool is_cancelled() const { return thread_.get_stop_token().stop_requested(); }

    // Whether it has ended, waiting for that as long as this.
    bool has_ended(std::chrono::milliseconds longest_wait = {}) const {
        return result_.wait_for(longest_wait) == std::future_status::ready;
    }
    // What it came to, once; throws what the work threw. Waits for its end.
    Result take() { return result_.get(); }

  private:
    std::atomic<double> fraction_ = 0.0;
    std::future<Result> result_;
    std::jthread thread_;  // last: it is joined while the others are still there
};

}  // namespace pectin

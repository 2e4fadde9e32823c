// Work on a thread of its own, so that the window stays responsive.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <new>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include "io/progress.h"

namespace pectin {

// The work begins in the constructor. The destructor asks it to stop and waits for its end; until
// then nothing that the work reads may change. All members must be called on the thread that
// constructed the task.
template <typename Result>
class BackgroundTask {
  public:
    // work: called once, with a Progress that it should advance often. If no thread can be created,
    // for want of threads or of memory, the constructor does the work itself.
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
        } catch (const std::bad_alloc&) {
            run({});
        }
    }
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    // The part of the work that is done, from 0 to 1.
    double fraction() const { return fraction_; }

    // Asks the work to stop, which it does soon afterwards.
    void cancel() { thread_.request_stop(); }
    bool is_cancelled() const { return thread_.get_stop_token().stop_requested(); }

    // Waits for the end of the work for at most this time, and returns whether it has ended.
    bool has_ended(std::chrono::milliseconds longest_wait = {}) const {
        return result_.wait_for(longest_wait) == std::future_status::ready;
    }
    // Waits for the end of the work and returns its result, or throws what the work threw.
    // Precondition: it has not been called before.
    Result take() { return result_.get(); }

  private:
    std::atomic<double> fraction_ = 0.0;
    std::future<Result> result_;
    std::jthread thread_;  // last, so that it is joined before the others are destroyed
};

}  // namespace pectin

#include "io/timed_calls.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace pectin {

// Makes one call at a time. `mutex` guards everything.
struct TimedCalls::Worker {
    enum class State { idle, called, returned, over };

    std::mutex mutex;
    std::condition_variable has_changed;
    State state = State::idle;
    std::function<void()> call;
    std::exception_ptr failure;

    void run();
};

void TimedCalls::Worker::run() {
    std::unique_lock lock(mutex);
    while (true) {
        has_changed.wait(lock, [this] { return state == State::called || state == State::over; });
        if (state == State::over) return;
        std::function<void()> present = std::exchange(call, nullptr);
        lock.unlock();
        std::exception_ptr what_failed;
        try {
            present();
        } catch (...) {
            what_failed = std::current_exception();
        }
        present = nullptr;  // what it owns is released before the caller goes on
        lock.lock();
        if (state == State::over) return;
        failure = what_failed;
        state = State::returned;
        has_changed.notify_all();
    }
}

TimedCalls::~TimedCalls() {
    if (!worker_) return;
    const std::lock_guard lock(worker_->mutex);
    worker_->state = Worker::State::over;
    worker_->has_changed.notify_all();
}

// Returns whether there is a thread for calls.
bool TimedCalls::start() {
    if (worker_) return true;
    const auto worker = std::make_shared<Worker>();
    try {
        std::thread([worker] { worker->run(); }).detach();
    } catch (const std::system_error&) {
        return false;
    }
    worker_ = worker;
    return true;
}

bool TimedCalls::run(std::function<void()> call, const Progress& progress,
                     const std::function<double()>& fraction) {
    if (is_waiting_) return false;
    if (!start()) {
        call();
        return true;
    }
    constexpr std::chrono::milliseconds kBetweenChecks{20};
    const auto now = [] { return std::chrono::steady_clock::now(); };
    auto last_change = now();
    double done = fraction();
    std::unique_lock lock(worker_->mutex);
    worker_->call = std::move(call);
    worker_->state = Worker::State::called;
    worker_->has_changed.notify_all();
    is_waiting_ = true;
    const auto has_returned = [this] { return worker_->state == Worker::State::returned; };
    while (!worker_->has_changed.wait_for(lock, kBetweenChecks, has_returned)) {
        lock.unlock();
        const double present = fraction();
        if (present != done) last_change = now();
        done = present;
        progress.advance(done);
        if (now() - last_change >= timeout_) return false;
        lock.lock();
    }
    is_waiting_ = false;
    worker_->state = Worker::State::idle;
    if (worker_->failure) std::rethrow_exception(std::exchange(worker_->failure, nullptr));
    return true;
}

}  // namespace pectin

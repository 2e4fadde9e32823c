// Tests BackgroundTask: its results, progress and cancellation.
#include "app/background_task.h"

#include <gtest/gtest.h>

#include <latch>
#include <stdexcept>
#include <string>

namespace pectin {
namespace {

using namespace std::chrono_literals;

// Runs until it is stopped.
int never_ending(const Progress& progress) {
    while (true) {
        progress.advance(0.5);
        std::this_thread::yield();
    }
}

TEST(BackgroundTask, ReturnsTheResult) {
    BackgroundTask<std::string> task([](const Progress&) { return std::string("done"); });
    EXPECT_TRUE(task.has_ended(1h));
    EXPECT_EQ(task.take(), "done");
    EXPECT_FALSE(task.is_cancelled());
}

TEST(BackgroundTask, RunsInTheBackgroundAndReportsProgress) {
    std::latch half_way(1), may_end(1);
    BackgroundTask<std::thread::id> task([&](const Progress& progress) {
        progress.advance(0.5);
        half_way.count_down();
        may_end.wait();
        progress.advance(1.0);
        return std::this_thread::get_id();
    });
    half_way.wait();
    EXPECT_EQ(task.fraction(), 0.5);
    EXPECT_FALSE(task.has_ended());
    EXPECT_FALSE(task.has_ended(1ms));
    may_end.count_down();
    EXPECT_TRUE(task.has_ended(1h));
    EXPECT_EQ(task.fraction(), 1.0);
    EXPECT_NE(task.take(), std::this_thread::get_id());
}

TEST(BackgroundTask, TakeRethrowsTheExceptionOfTheWork) {
    BackgroundTask<int> task([](const Progress&) -> int { throw std::runtime_error("no"); });
    EXPECT_TRUE(task.has_ended(1h));
    EXPECT_THROW(task.take(), std::runtime_error);
}

TEST(BackgroundTask, CancelStopsTheWork) {
    BackgroundTask<int> task(never_ending);
    EXPECT_FALSE(task.has_ended(5ms));
    task.cancel();
    EXPECT_TRUE(task.is_cancelled());
    EXPECT_TRUE(task.has_ended(1h));
    EXPECT_THROW(task.take(), Cancelled);
}

TEST(BackgroundTask, DestructorStopsTheWorkAndWaitsForIt) {
    std::atomic<bool> has_begun = false, has_ended = false;
    {
        BackgroundTask<int> task([&](const Progress& progress) {
            has_begun = true;
            try {
                return never_ending(progress);
            } catch (const Cancelled&) {
                std::this_thread::sleep_for(20ms);
                has_ended = true;
                throw;
            }
        });
        while (!has_begun) std::this_thread::yield();
    }
    EXPECT_TRUE(has_ended);
}

}  // namespace
}  // namespace pectin

#include "geometry/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#ifdef PECTIN_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace pectin {
namespace {

// Tells ThreadSanitizer how TBB, which is built without it, orders the pieces of a loop: everything
// before fork() happens before everything after enter(), and everything before leave() happens
// before everything after join(). Pieces are not ordered among themselves. In other builds this
// does nothing.
struct LoopOrder {
#ifdef PECTIN_THREAD_SANITIZER
    static inline char begin = 0, end = 0;
    static void fork() { __tsan_release(&begin); }
    static void enter() { __tsan_acquire(&begin); }
    static void leave() { __tsan_release(&end); }
    static void join() { __tsan_acquire(&end); }
#else
    static void fork() {}
    static void enter() {}
    static void leave() {}
    static void join() {}
#endif
};

// The number of further threads that the system lets this process start now, up to those of the
// machine. TBB ends the program if it cannot start a thread that it expects, so this is found out
// once before TBB starts any.
std::size_t available_threads() {
    const std::size_t wanted = std::max(1u, std::thread::hardware_concurrency()) - 1;
    std::mutex starting;
    std::vector<std::jthread> threads;
    const std::scoped_lock all_at_once(starting);  // released first, so that the threads can end
    try {
        while (threads.size() < wanted) {
            threads.emplace_back([&] { const std::scoped_lock wait(starting); });
        }
    } catch (const std::system_error&) {
    }
    return threads.size();
}

// The longest time to wait for threads, which normally start within some milliseconds. Afterwards
// the program continues with fewer threads.
constexpr std::chrono::milliseconds kLongestStart{500};

// If memory ends while TBB 2022 starts, TBB waits forever: in order to throw it needs a lock that
// it holds already. So this throws std::bad_alloc unless there is clearly more memory than TBB
// takes then, which is a little more than 1 MB with two threads.
void check_memory_for_start() {
    constexpr std::size_t kBlock = 64 * 1024;
    const std::size_t count = 64 + 2 * std::size_t{std::thread::hardware_concurrency()};
    std::vector<std::vector<std::byte>> blocks(count);
    for (std::vector<std::byte>& block : blocks) block.resize(kBlock);
}

// Makes TBB start its threads now and waits until all of them have begun to work. Later there may
// be no memory for their stacks, or for the list of tasks that each thread gets with its first
// task. A loop for which TBB cannot allocate such a list never ends.
void start_threads(std::size_t threads) {
    const auto most = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const std::size_t expected = std::min(threads, most);
    const auto deadline = std::chrono::steady_clock::now() + kLongestStart;
    std::atomic<std::size_t> arrived = 0;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, expected, 1),
        [&](const tbb::blocked_range<std::size_t>&) {
            ++arrived;
            while (arrived < expected && std::chrono::steady_clock::now() < deadline) {
                std::this_thread::yield();
            }
            tbb::parallel_for(
                0, 2, [](int) {}, tbb::simple_partitioner());
        },
        tbb::simple_partitioner());
}

// Starts TBB, limited to the threads that can be started. Returns null if the system sets no limit
// below the number of the machine.
const tbb::global_control* limit_threads() {
    const std::size_t threads = 1 + available_threads();
    check_memory_for_start();  // the threads keep the memory of their stacks
    if (threads >= std::thread::hardware_concurrency()) {
        start_threads(threads);
        return nullptr;
    }
    // Never destroyed, since without the limit TBB would start the threads at the end of the
    // program.
    const auto* const limit =
        new tbb::global_control(tbb::global_control::max_allowed_parallelism, threads);
    start_threads(threads);
    return limit;
}

}  // namespace

void prepare_parallel_loops() {
    [[maybe_unused]] static const tbb::global_control* const limit = limit_threads();
    // A thread that did not start the others gets its list of tasks now.
    thread_local bool is_prepared = false;
    if (is_prepared) return;
    check_memory_for_start();
    tbb::parallel_for(
        0, 2, [](int) {}, tbb::simple_partitioner());
    is_prepared = true;
}

void for_pieces_on_all_threads(std::uint32_t first, std::uint32_t end, std::uint32_t piece,
                               const Piece& work) {
    prepare_parallel_loops();
    LoopOrder::fork();
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(first, end, piece),
        [&](const tbb::blocked_range<std::uint32_t>& range) {
            LoopOrder::enter();
            work(range.begin(), range.end());
            LoopOrder::leave();
        },
        tbb::static_partitioner());
    LoopOrder::join();
}

}  // namespace pectin

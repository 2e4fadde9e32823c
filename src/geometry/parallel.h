// Parallel loops over the elements of flat arrays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>

namespace pectin {

// The number of elements that one thread takes at a time. Starting other threads costs some
// microseconds, in which a streaming pass handles a few thousand elements.
inline constexpr std::uint32_t kPiece = 8192;

// Starts the threads, unless that was done before, and prepares the calling thread. Loops do so
// themselves, but with too little memory for it they may never end. So a program that goes on
// without memory calls this first, on each thread that will run loops. Throws std::bad_alloc.
void prepare_parallel_loops();

using Piece = std::function<void(std::uint32_t first, std::uint32_t end)>;
void for_pieces_on_all_threads(std::uint32_t first, std::uint32_t end, std::uint32_t piece,
                               const Piece& work);

// Calls work(first, end) for pieces of [first, end), in no particular order, and on all threads if
// there are more than two pieces. Precondition: no piece accesses what another one writes, unless
// atomically. The result then does not depend on the number of threads.
template <typename Work>
void for_pieces(std::uint32_t first, std::uint32_t end, const Work& work,
                std::uint32_t piece = kPiece) {
    if (end - first <= 2 * piece) {
        if (first < end) work(first, end);
    } else {
        for_pieces_on_all_threads(first, end, piece, std::cref(work));
    }
}

// Calls work(item) for each item, each on one thread. If possible a thread gets the same items in
// every call, so that their data is still in its cache. If there is no memory to start the threads,
// the calling thread handles the remaining items. So work that does not throw is always done, and
// work that throws std::bad_alloc is tried once more.
template <typename Item, std::size_t count, typename Work>
void for_each_concurrently(std::array<Item, count>& items, const Work& work) {
    std::array<bool, count> done{};
    const auto some = [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
            if (done[i]) continue;
            work(items[i]);
            done[i] = true;
        }
    };
    try {
        for_pieces_on_all_threads(0, count, 1, some);
    } catch (const std::bad_alloc&) {
        some(0, count);
    }
}

}  // namespace pectin

// Work on the elements of flat arrays, on all threads where there is enough of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>

namespace pectin {

// Elements that one thread takes at a time. Starting others costs some microseconds, in which a
// streaming pass does a few thousand.
inline constexpr std::uint32_t kPiece = 8192;
// The same of what takes as long as a split.
inline constexpr std::uint32_t kPieceOfSplits = 128;

using Piece = std::function<void(std::uint32_t first, std::uint32_t end)>;
void for_pieces_on_all_threads(std::uint32_t first, std::uint32_t end, std::uint32_t piece,
                               const Piece& work);

// Calls work(first, end) for pieces of [first, end), in no order. No piece may touch what another
// writes, so the result does not depend on the number of threads.
template <typename Work>
void for_pieces(std::uint32_t first, std::uint32_t end, const Work& work,
                std::uint32_t piece = kPiece) {
    if (end - first <= 2 * piece) {
        if (first < end) work(first, end);
    } else {
        for_pieces_on_all_threads(first, end, piece, std::cref(work));
    }
}

// Work that another thread may do while this one goes on; if none comes to it, wait() does.
class Meanwhile {
  public:
    Meanwhile();
    ~Meanwhile();  // waits
    void run(std::function<void()> work);
    void wait();
    bool is_running() const { return running_; }

  private:
    struct Group;
    std::unique_ptr<Group> group_;
    bool running_ = false;
};

}  // namespace pectin

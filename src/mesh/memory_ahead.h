// Memory that edits to come will be the first to write.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pectin {

// The system hands out a page when it is first written, and clears it then, which takes longer than
// a split. Another thread may have that done while this one edits what lies before it.
class MemoryAhead {
  public:
    // What is added next are the same arrays as before, in the same order.
    void start_again() { next_ = 0; }
    void add(std::span<std::byte> range) {
        if (next_ == ranges_.size()) ranges_.push_back({});
        Range& last = ranges_[next_++];
        // What has been touched already need not be again.
        const bool goes_on = range.data() <= last.end && range.data() >= last.begin;
        last = {goes_on ? last.end : range.data(), range.data() + range.size()};
    }

    // Writes a byte in every page. What it writes is nobody's yet.
    void touch() const {
        for (const Range& range : ranges_) {
            for (std::byte* at = range.begin; at < range.end; at += kPage) *at = std::byte{0};
        }
    }

  private:
    struct Range {
        std::byte* begin = nullptr;
        std::byte* end = nullptr;
    };
    static constexpr std::ptrdiff_t kPage = 4096;  // where pages are larger, it costs a little more
    std::vector<Range> ranges_;
    std::size_t next_ = 0;
};

}  // namespace pectin

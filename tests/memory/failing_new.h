// An allocator that can be told to fail.
#pragma once

#include <cstddef>

namespace pectin::test {

// While one lives, so many allocations are served and then one fails, or all from there on:
// operator new throws std::bad_alloc, and large arrays get nothing from the system. On any thread;
// one at a time.
class FailingNew {
  public:
    enum class How { once, from_there_on };
    FailingNew(std::size_t served, How how);
    FailingNew(const FailingNew&) = delete;
    FailingNew& operator=(const FailingNew&) = delete;
    ~FailingNew();

    bool has_failed() const;
};

}  // namespace pectin::test

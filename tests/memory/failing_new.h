// An allocator that can be told to fail.
#pragma once

#include <cstddef>

namespace pectin::test {

// While one lives, operator new serves so many allocations and then throws std::bad_alloc: once, or
// from there on. On any thread; one at a time.
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

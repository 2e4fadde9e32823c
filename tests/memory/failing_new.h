// Makes allocations fail, and chooses the allocations that fail.
#pragma once

#include <cstddef>

namespace pectin::test {

// During the lifetime of the object, `served` allocations succeed. Then one fails, or all following
// ones fail. If an allocation fails, operator new throws std::bad_alloc, and large arrays get no
// memory from the system. Allocations of all threads count. Only one object may exist at a time.
class FailingNew {
  public:
    enum class How { once, from_there_on };
    FailingNew(std::size_t served, How how);
    FailingNew(const FailingNew&) = delete;
    FailingNew& operator=(const FailingNew&) = delete;
    ~FailingNew();

    bool has_failed() const;
};

// The numbers of allocations that succeed before one fails. In a long run (PECTIN_TEST_LONG) these
// are all numbers from 0. Otherwise they are a sample: all small numbers, then about every nth
// number near n·sparseness. A random offset, which is printed, gives each process another sample.
// PECTIN_TEST_OFFSET sets the offset. Under sanitizers the sample is half as large.
class FailurePoints {
  public:
    explicit FailurePoints(std::size_t sparseness);

    std::size_t served() const { return served_; }
    void advance();

  private:
    std::size_t sparseness_, offset_ = 0, served_ = 0;
    bool takes_all_ = false;
};

}  // namespace pectin::test

// An allocator that can be told to fail, and where it is to.
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

// How many allocations are served before one fails: in a long run (PECTIN_TEST_LONG) every number
// from 0 on. Otherwise a sample: every small number, then every nth of about n·sparseness. Its gaps
// lie elsewhere in each process, by a random offset, which is printed; PECTIN_TEST_OFFSET sets it.
// Under sanitizers the sample is half as large.
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

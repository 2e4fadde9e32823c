#include "memory/failing_new.h"

#include <sys/mman.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <random>

#include "support/test_run.h"

namespace pectin::test {
namespace {

std::atomic<bool> armed = false, fails_on = false, failed = false;
std::atomic<std::size_t> left = 0;

bool fails() {
    if (!armed) return false;
    if (failed) return fails_on;
    std::size_t known = left;
    while (known > 0 && !left.compare_exchange_weak(known, known - 1)) {
    }
    return known == 0 && (!failed.exchange(true) || fails_on);
}

void* allocated(std::size_t size) {
    void* const block = fails() ? nullptr : std::malloc(size > 0 ? size : 1);
    if (!block) throw std::bad_alloc();
    return block;
}

}  // namespace

FailingNew::FailingNew(std::size_t served, How how) {
    left = served;
    failed = false;
    fails_on = how == How::from_there_on;
    armed = true;
}

FailingNew::~FailingNew() { armed = false; }

bool FailingNew::has_failed() const { return failed; }

FailurePoints::FailurePoints(std::size_t sparseness)
    : sparseness_(test::is_sanitized() ? (sparseness + 1) / 2 : sparseness),
      takes_all_(test::is_long()) {
    if (takes_all_) return;
    const char* const chosen = std::getenv("PECTIN_TEST_OFFSET");
    offset_ = chosen ? std::strtoull(chosen, nullptr, 10) : std::random_device()() % sparseness_;
    std::printf("a sample of the allocations fails: PECTIN_TEST_OFFSET=%zu\n", offset_);
}

void FailurePoints::advance() { served_ += takes_all_ ? 1 : 1 + (served_ + offset_) / sparseness_; }

}  // namespace pectin::test

// GrowingArray allocates by these functions, which the linker option --wrap replaces.
extern "C" {
void* __real_realloc(void* block, std::size_t size);
void* __wrap_realloc(void* block, std::size_t size) {
    return pectin::test::fails() ? nullptr : __real_realloc(block, size);
}
void* __real_mmap(void* at, std::size_t size, int protection, int flags, int file, off_t offset);
void* __wrap_mmap(void* at, std::size_t size, int protection, int flags, int file, off_t offset) {
    return pectin::test::fails() ? MAP_FAILED
                                 : __real_mmap(at, size, protection, flags, file, offset);
}
}

// The operators for alignments beyond that of malloc are not replaced.
void* operator new(std::size_t size) { return pectin::test::allocated(size); }
void* operator new[](std::size_t size) { return pectin::test::allocated(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return pectin::test::fails() ? nullptr : std::malloc(size > 0 ? size : 1);
}
void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept {
    return operator new(size, nothrow);
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { std::free(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }

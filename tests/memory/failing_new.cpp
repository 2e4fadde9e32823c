#include "memory/failing_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

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

}  // namespace pectin::test

// Those of alignments beyond malloc's stay the library's.
void* operator new(std::size_t size) { return pectin::test::allocated(size); }
void* operator new[](std::size_t size) { return pectin::test::allocated(size); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }

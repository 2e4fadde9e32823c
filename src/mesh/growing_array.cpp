#include "mesh/growing_array.h"

#include <sys/mman.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>

namespace pectin {
namespace {

constexpr std::size_t kPage = 4096;

std::size_t up_to(std::size_t multiple, std::size_t size) {
    return (size + multiple - 1) / multiple * multiple;
}

// Blocks begin at different distances from a huge page. Where many arrays are walked through at the
// same time, elements of the same index would otherwise compete for the same places in the caches.
std::size_t next_offset() {
    constexpr std::size_t kOffset = kPage + 256, kOffsets = kMostOffset / kOffset + 1;
    static std::atomic<std::size_t> blocks = 0;
    return blocks.fetch_add(1, std::memory_order_relaxed) % kOffsets * kOffset;
}

// The pages of a block that begins `offset` bytes behind a huge page; so many before its end
// another begins.
std::size_t in_pages(std::size_t offset, std::size_t size) {
    const std::size_t pages = up_to(kPage, offset + size), huge = up_to(kHugePage, pages);
    return huge - pages <= kMostOffset ? huge : pages;
}

// A mapping from a multiple of a huge page on.
std::byte* mapped(std::size_t pages) {
    void* const room = mmap(nullptr, pages + kHugePage, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) return nullptr;
    const std::size_t before = kHugePage - reinterpret_cast<std::uintptr_t>(room) % kHugePage;
    std::byte* const block = static_cast<std::byte*>(room) + before;
    munmap(room, before);
    if (before < kHugePage) munmap(block + pages, kHugePage - before);
    madvise(block, pages, MADV_HUGEPAGE);  // where the system has none, these are small pages
    return block;
}

std::size_t offset_of(const std::byte* block) {
    return reinterpret_cast<std::uintptr_t>(block) % kHugePage;
}

// Of a block that was in no huge pages.
std::byte* moved_to_huge_pages(std::byte* block, std::size_t size, std::size_t new_size) {
    const std::size_t offset = next_offset();
    std::byte* const pages = mapped(in_pages(offset, new_size));
    if (!pages) return nullptr;
    if (size > 0) std::memcpy(pages + offset, block, size);
    std::free(block);
    return pages + offset;
}

// Of one that was: its pages move, but for a last one that is not whole.
std::byte* moved_with_pages(std::byte* block, std::size_t size, std::size_t new_size) {
    const std::size_t offset = offset_of(block), used = offset + size;
    const std::size_t old_pages = in_pages(offset, size), new_pages = in_pages(offset, new_size);
    std::byte *const old = block - offset, *const pages = mapped(new_pages);
    if (!pages) return nullptr;
    // One mapping in the end, since no more than one can be moved at a time.
    const std::size_t whole = old_pages / kHugePage * kHugePage;
    if (mremap(old, whole, new_pages, MREMAP_MAYMOVE | MREMAP_FIXED, pages) == MAP_FAILED)
        return nullptr;  // `pages` may be another's by now: their addresses are lost, not memory
    for (std::size_t i = whole; i < used; i += kPage) {
        std::memcpy(pages + i, old + i, std::min(kPage, used - i));
    }
    if (old_pages > whole) munmap(old + whole, old_pages - whole);
    return pages + offset;
}

}  // namespace

void* grown_block(void* block, std::size_t size, std::size_t new_size) noexcept {
    if (new_size < kHugePage) return std::realloc(block, new_size);
    auto* const old = static_cast<std::byte*>(block);
    return size < kHugePage ? moved_to_huge_pages(old, size, new_size)
                            : moved_with_pages(old, size, new_size);
}

void free_block(void* block, std::size_t size) noexcept {
    if (size < kHugePage) {
        std::free(block);
        return;
    }
    auto* const from = static_cast<std::byte*>(block);
    munmap(from - offset_of(from), in_pages(offset_of(from), size));
}

}  // namespace pectin

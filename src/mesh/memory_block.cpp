#include "mesh/memory_block.h"

#include <cstdlib>

#if defined(__linux__) && !defined(PECTIN_PLAIN_BLOCKS)

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace pectin {
namespace {

constexpr std::size_t kPage = 4096;

std::size_t in_pages(std::size_t size) { return (size + kPage - 1) / kPage * kPage; }

// Maps pages from a multiple of kHugePage on, so that the system can use huge pages for them. The
// first write to a huge page costs one page fault, where small pages cost one each.
std::byte* mapped(std::size_t size) {
    const std::size_t pages = in_pages(size);
    void* const mapping = mmap(nullptr, pages + kHugePage, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapping == MAP_FAILED) return nullptr;
    const std::size_t before = kHugePage - reinterpret_cast<std::uintptr_t>(mapping) % kHugePage;
    std::byte* const block = static_cast<std::byte*>(mapping) + before;
    munmap(mapping, before);
    if (before < kHugePage) munmap(block + pages, kHugePage - before);
    madvise(block, pages, MADV_HUGEPAGE);  // without huge pages this fails, which is harmless
    return block;
}

void unmap(std::byte* block, std::size_t from, std::size_t size) {
    if (in_pages(size) > from) munmap(block + from, in_pages(size) - from);
}

}  // namespace

// Blocks smaller than kHugePage come from realloc, larger ones from mmap.
void* grown_block(void* block, std::size_t size, std::size_t new_size) noexcept {
    if (new_size < kHugePage) return std::realloc(block, new_size);
    std::byte* const grown = mapped(new_size);
    if (!grown) return nullptr;
    auto* const old = static_cast<std::byte*>(block);
    if (size < kHugePage) {
        if (size > 0) std::memcpy(grown, old, size);
        std::free(old);
        return grown;
    }
    // Whole huge pages are moved and the rest is copied, so that the result is a single mapping:
    // mremap cannot move more than one at a time.
    const std::size_t whole = in_pages(size) / kHugePage * kHugePage;
    if (mremap(old, whole, in_pages(new_size), MREMAP_MAYMOVE | MREMAP_FIXED, grown) == MAP_FAILED)
        return nullptr;  // mremap may have unmapped `grown` already, so it must not be unmapped
                         // here
    for (std::size_t i = whole; i < size; i += kPage) {
        std::memcpy(grown + i, old + i, std::min(kPage, size - i));
    }
    unmap(old, whole, size);
    return grown;
}

void free_block(void* block, std::size_t size) noexcept {
    if (size >= kHugePage) {
        unmap(static_cast<std::byte*>(block), 0, size);
    } else {
        std::free(block);
    }
}

}  // namespace pectin

#else

namespace pectin {

void* grown_block(void* block, std::size_t, std::size_t new_size) noexcept {
    return std::realloc(block, new_size);
}

void free_block(void* block, std::size_t) noexcept { std::free(block); }

}  // namespace pectin

#endif

#include "mesh/growing_array.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>

namespace pectin {
namespace {

constexpr std::size_t kPage = 4096;

std::size_t in_pages(std::size_t size) { return (size + kPage - 1) / kPage * kPage; }

// From a multiple of a huge page on.
std::byte* mapped(std::size_t size) {
    const std::size_t pages = in_pages(size);
    void* const mapping = mmap(nullptr, pages + kHugePage, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapping == MAP_FAILED) return nullptr;
    const std::size_t before = kHugePage - reinterpret_cast<std::uintptr_t>(mapping) % kHugePage;
    std::byte* const block = static_cast<std::byte*>(mapping) + before;
    munmap(mapping, before);
    if (before < kHugePage) munmap(block + pages, kHugePage - before);
    madvise(block, pages, MADV_HUGEPAGE);  // where the system has none, these are small pages
    return block;
}

void unmap(std::byte* block, std::size_t from, std::size_t size) {
    if (in_pages(size) > from) munmap(block + from, in_pages(size) - from);
}

}  // namespace

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
    // One mapping in the end, since no more than one can be moved at a time.
    const std::size_t whole = in_pages(size) / kHugePage * kHugePage;
    if (mremap(old, whole, in_pages(new_size), MREMAP_MAYMOVE | MREMAP_FIXED, grown) == MAP_FAILED)
        return nullptr;  // `grown` may be another's by now: its addresses are lost, not memory
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

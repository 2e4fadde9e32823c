#include "mesh/growing_array.h"

#include <sys/mman.h>

#include <cstdlib>

namespace pectin {
namespace {

constexpr std::size_t kLarge = std::size_t{1} << 17;  // as the allocator has it at first

void* mapped(std::size_t size) {
    void* const block =
        mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return block == MAP_FAILED ? nullptr : block;
}

}  // namespace

void* resized_block(void* block, std::size_t size, std::size_t new_size) noexcept {
    if (size < kLarge && new_size < kLarge) return std::realloc(block, new_size);
    if (size >= kLarge && new_size >= kLarge) {
        void* const moved = mremap(block, size, new_size, MREMAP_MAYMOVE);
        return moved == MAP_FAILED ? nullptr : moved;
    }
    void* const moved = new_size >= kLarge ? mapped(new_size) : std::malloc(new_size);
    if (!moved) return nullptr;
    if (size > 0) std::memcpy(moved, block, std::min(size, new_size));
    free_block(block, size);
    return moved;
}

void free_block(void* block, std::size_t size) noexcept {
    if (size >= kLarge) {
        munmap(block, size);
    } else {
        std::free(block);
    }
}

}  // namespace pectin

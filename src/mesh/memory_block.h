// Blocks of memory that grow without being copied where the system allows it.
#pragma once

#include <cstddef>

namespace pectin {

// The size from which a block consists of huge pages where the system has them.
inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

// Linux moves large blocks by their page tables (mremap) and backs them with huge pages; elsewhere,
// or with PECTIN_PLAIN_BLOCKS defined, blocks come from realloc.
#if defined(__linux__) && !defined(PECTIN_PLAIN_BLOCKS)
inline constexpr bool kHasPagedBlocks = true;
#else
inline constexpr bool kHasPagedBlocks = false;
#endif

// Returns a block of new_size bytes that begins with the bytes of `block`, which is freed. `size`
// is the size that `block` was made with, 0 if it is null. Returns null if there is no memory; the
// block is then unchanged. Precondition: new_size > size.
void* grown_block(void* block, std::size_t size, std::size_t new_size) noexcept;
void free_block(void* block, std::size_t size) noexcept;

}  // namespace pectin

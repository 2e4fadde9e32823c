// Loops written with the compiler's own vectors, in a version for each width of vector that the
// machine may have. All versions round alike: no multiplication is fused with an addition.
#pragma once

#include <cstdint>

// Versions for AVX2 and AVX-512 are compiled beside the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PECTIN_HAS_WIDE_VERSIONS 1
#else
#define PECTIN_HAS_WIDE_VERSIONS 0
#endif

namespace pectin {

// The versions, from the narrowest to the widest: vectors of 16, 32 and 64 bytes.
enum class Vectors : std::uint8_t { plain, avx2, avx512 };

// The widest that the machine that this runs on has.
inline Vectors widest_vectors() {
#if PECTIN_HAS_WIDE_VERSIONS
    if (__builtin_cpu_supports("avx512f") != 0) return Vectors::avx512;
    if (__builtin_cpu_supports("avx2") != 0) return Vectors::avx2;
#endif
    return Vectors::plain;
}

}  // namespace pectin

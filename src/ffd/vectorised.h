// Selects among versions of loops that are written with the compiler's vector types, one version
// for each instruction set. All versions round alike, since none fuses a multiplication with an
// addition.
#pragma once

#include <cstdint>

// Set if versions for AVX2 and AVX-512 are compiled beside the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PECTIN_HAS_WIDE_VERSIONS 1
#else
#define PECTIN_HAS_WIDE_VERSIONS 0
#endif

namespace pectin {

// The instruction sets, with vectors of 16, 32 and 64 bytes.
enum class Vectors : std::uint8_t { plain, avx2, avx512 };

// The widest vectors of the machine on which this runs.
inline Vectors widest_vectors() {
#if PECTIN_HAS_WIDE_VERSIONS
    if (__builtin_cpu_supports("avx512f") != 0) return Vectors::avx512;
    if (__builtin_cpu_supports("avx2") != 0) return Vectors::avx2;
#endif
    return Vectors::plain;
}

}  // namespace pectin

// Loops written with the compiler's own vectors, in a version for each width of vector that the
// machine may have. All versions round alike: no multiplication is fused with an addition.
#pragma once

// A version for AVX2 is compiled beside the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PECTIN_HAS_AVX2_VERSIONS 1
#else
#define PECTIN_HAS_AVX2_VERSIONS 0
#endif

namespace pectin {

// Whether the machine that this runs on has it.
inline bool runs_avx2() {
#if PECTIN_HAS_AVX2_VERSIONS
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

}  // namespace pectin

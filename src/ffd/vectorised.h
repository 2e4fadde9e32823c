// Functions whose loops the compiler vectorises, in a version for each width of vector that it may
// find where it runs. All versions round alike: no multiplication is fused with an addition.
// Measured (ns a normal, the loop of drag_stream.cpp): plain 7.1, AVX2 3.2, AVX-512 5.5, whose wide
// shuffles cost more than they spare.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PECTIN_VECTORISED __attribute__((target_clones("avx2", "default")))
#else
#define PECTIN_VECTORISED
#endif

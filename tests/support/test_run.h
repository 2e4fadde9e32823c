// How the tests are run: scripts/test sets these variables of the environment.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace pectin::test {

// True under sanitizers, which make the tests 10 to 30 times slower.
inline bool is_sanitized() { return std::getenv("PECTIN_TEST_SANITIZED") != nullptr; }

// True in a long run (scripts/test --long), which tries more cases of randomised tests.
inline bool is_long() { return std::getenv("PECTIN_TEST_LONG") != nullptr; }

// The number of cases to run instead of `count`: more in a long run, fewer under sanitizers.
inline int case_count(int count) {
    if (is_sanitized()) count = std::min(count, std::max(5, count / 8));
    if (is_long()) count *= 10;
    return count;
}

}  // namespace pectin::test

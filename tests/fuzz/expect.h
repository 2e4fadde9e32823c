// Checks for conditions that must hold for every input of a fuzzer.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace pectin::fuzz {

// Prints the condition that does not hold and ends the process, so that libFuzzer keeps the input.
inline void expect(bool holds, const std::string& what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what.c_str());
    std::abort();
}

}  // namespace pectin::fuzz

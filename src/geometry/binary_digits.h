// The number of binary digits of a count, for limits on work that grows as n log n.
#pragma once

#include <bit>
#include <cstddef>

namespace pectin {

// 0 for 0. std::bit_width returns an int or the type of its argument, depending on the version of
// the standard library.
constexpr std::size_t binary_digits(std::size_t n) {
    return static_cast<std::size_t>(std::bit_width(n));
}

}  // namespace pectin

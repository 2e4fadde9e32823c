// Divides blocks of different heights into columns.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pectin {

// Keeps the blocks in their order and makes the columns as equal as possible: the sum of the
// squares of their heights is least. Returns the number of the column of each block, from 0;
// columns may be empty at the end. Precondition: columns > 0. Cost: O(columns · blocks²).
std::vector<std::size_t> balanced_columns(std::span<const float> heights, std::size_t columns);

}  // namespace pectin

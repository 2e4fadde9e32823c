#include "app/ui/columns.h"

#include <cassert>
#include <limits>

namespace pectin {

std::vector<std::size_t> balanced_columns(std::span<const float> heights, std::size_t columns) {
    assert(columns > 0);
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const std::size_t count = heights.size();
    // Of the first n blocks in c columns: the least sum, and where the last of the columns begins.
    std::vector<std::vector<double>> least(columns + 1, std::vector<double>(count + 1, kNone));
    std::vector<std::vector<std::size_t>> begin(columns + 1, std::vector<std::size_t>(count + 1));
    least[0][0] = 0.0;
    for (std::size_t c = 1; c <= columns; ++c) {
        for (std::size_t n = 0; n <= count; ++n) {
            double height = 0.0;
            for (std::size_t first = n;; --first) {
                const double sum = least[c - 1][first] + height * height;
                if (sum < least[c][n]) {
                    least[c][n] = sum;
                    begin[c][n] = first;
                }
                if (first == 0) break;
                height += static_cast<double>(heights[first - 1]);
            }
        }
    }
    std::vector<std::size_t> column_of(count);
    std::size_t end = count;
    for (std::size_t c = columns; c > 0; --c) {
        for (std::size_t i = begin[c][end]; i < end; ++i) column_of[i] = c - 1;
        end = begin[c][end];
    }
    return column_of;
}

}  // namespace pectin

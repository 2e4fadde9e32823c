#include "app/ui/figure_text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace pectin {

std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
    return digits;
}

std::string counted(std::uint64_t number, const char* one, const char* many) {
    return grouped(number) + ' ' + (number == 1 ? one : many);
}

std::string formatted(const char* format, double value) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string megabytes(std::size_t bytes) {
    const double number = 1e-6 * static_cast<double>(bytes);
    if (number < 10.0) return formatted("%.1f MB", number);
    return grouped(static_cast<std::uint64_t>(std::llround(number))) + " MB";
}

std::string undo_memory(const ObjectFigures& object) {
    return megabytes(object.undo_bytes) +
           (object.undo_limit ? " of " + megabytes(*object.undo_limit) : "");
}

}  // namespace pectin

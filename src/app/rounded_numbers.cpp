#include "app/rounded_numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <system_error>

namespace pectin {
namespace {

constexpr std::ptrdiff_t kDigits = 4;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Whether the number has a fraction and too many digits, counting those before the point.
bool is_long_fraction(std::string_view number) {
    const bool has_point = number.find('.') != number.npos || number.find('e') != number.npos;
    return has_point && std::count_if(number.begin(), number.end(), is_digit) > kDigits;
}

}  // namespace

std::string rounded_numbers(std::string_view sentence) {
    std::string rounded;
    for (std::size_t at = 0; at < sentence.size();) {
        const char* const begin = sentence.data() + at;
        double value = 0.0;
        const char* end = begin;
        if (is_digit(sentence[at])) {
            const auto read = std::from_chars(begin, sentence.data() + sentence.size(), value);
            if (read.ec == std::errc{}) end = read.ptr;
        }
        const std::string_view number(begin, static_cast<std::size_t>(end - begin));
        if (!is_long_fraction(number)) {
            const std::size_t length = std::max<std::size_t>(number.size(), 1);
            rounded += sentence.substr(at, length);
            at += length;
            continue;
        }
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.4g", value);
        rounded += text.data();
        at += number.size();
    }
    return rounded;
}

}  // namespace pectin

#include "io/printable.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pectin {
namespace {

// The number of bytes of the UTF-8 character at the beginning of `text` (RFC 3629). 0 if there is
// no valid one, or if it is a control character.
std::size_t printable_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
    const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || size > text.size()) return 0;
    std::uint32_t code = first & (0x7fu >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    const bool is_too_long = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
    const bool is_surrogate = code >= 0xd800 && code < 0xe000;
    const bool is_control =
        code < 0xa0 || code == 0x2028 || code == 0x2029;  // C1 and line separators
    const bool changes_direction =
        (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return is_too_long || is_surrogate || is_control || changes_direction || code > 0x10ffff ? 0
                                                                                             : size;
}

}  // namespace

std::string printable(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        if (const std::size_t size = printable_character(text)) {
            shown += text.substr(0, size);
            text.remove_prefix(size);
        } else {
            const auto byte = static_cast<unsigned char>(text.front());
            shown += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
            text.remove_prefix(1);
        }
    }
    return shown;
}

std::string quoted_word(std::string_view word) {
    constexpr std::size_t kMaxLength = 60;
    if (word.size() <= kMaxLength) return "'" + printable(word) + "'";
    std::size_t end = kMaxLength;
    // Does not cut inside a UTF-8 character.
    while (end > 0 && (static_cast<unsigned char>(word[end]) & 0xc0) == 0x80) --end;
    return "'" + printable(word.substr(0, end > 0 ? end : kMaxLength)) + "...'";
}

}  // namespace pectin

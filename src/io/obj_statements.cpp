#include "io/obj_statements.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

#include "io/printable.h"

namespace pectin {
namespace {

std::string_view without_leading_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return text;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return without_leading_blanks(text);
}

// The text up to the first blank.
std::string_view leading_token(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && !is_blank(text[end])) ++end;
    return text.substr(0, end);
}

// Tells whether a decimal number beyond the range of its type is too small, not too large. Counting
// the digits before the first that is not 0 is exact enough, because the limits are dozens of
// powers of ten away.
bool is_tiny(std::string_view number) {
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    const std::string_view mantissa = number.substr(0, e);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    int exponent = 0;
    if (e < number.size()) {
        std::string_view digits = number.substr(e + 1);
        const bool negative = digits.starts_with('-');
        if (digits.starts_with('+')) digits.remove_prefix(1);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        if (read.ec == std::errc::result_out_of_range) return negative;
    }
    return static_cast<double>(point) - static_cast<double>(first) + exponent < 0.0;
}

// The first c in [begin, end), or end if there is none.
const char* find(char c, const char* begin, const char* end) {
    const void* found =
        begin == end ? nullptr : std::memchr(begin, c, static_cast<std::size_t>(end - begin));
    return found == nullptr ? end : static_cast<const char*>(found);
}

}  // namespace

ObjStatements::ObjStatements(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    at_ = text.data();
    end_ = at_ + text.size();
    newline_ = find('\n', at_, end_);
}

std::string_view ObjStatements::take_line() {
    if (newline_ < at_) newline_ = find('\n', at_, end_);
    const char* const begin = at_;
    const char* const end = find('\r', begin, newline_);
    at_ = end == newline_ || end + 1 == newline_ ? newline_ : end;
    if (at_ != end_) ++at_;
    ++lines_taken_;
    return {begin, end};
}

std::string_view ObjStatements::joined_with_continuations(std::string_view line) {
    joined_.clear();
    while (line.ends_with('\\')) {
        joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
        line = at_ == end_ ? std::string_view{} : take_line();
    }
    joined_.append(line);
    return joined_;
}

bool ObjStatements::next() {
    while (at_ != end_) {
        line_ = lines_taken_ + 1;
        std::string_view statement = take_line();
        const std::string_view content = without_leading_blanks(statement);
        if (content.empty()) continue;
        if (content.front() == '#' && leading_token(content) != "#MRGB") continue;
        if (statement.ends_with('\\')) statement = joined_with_continuations(statement);

        statement = trimmed(statement);
        keyword_ = leading_token(statement);
        arguments_ = trimmed(statement.substr(keyword_.size()));
        if (!keyword_.empty()) return true;
    }
    return false;
}

template <typename Real>
std::optional<Real> parse_number(std::string_view token, std::string& why_not) {
    std::string_view digits = token;
    const bool plus = digits.starts_with('+');
    if (plus) digits.remove_prefix(1);

    Real number = 0;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, number);
    const bool is_number = read.ec != std::errc::invalid_argument && read.ptr == end;
    const auto refuse = [&](std::string_view reason) {
        why_not = quoted_word(token) + " " + std::string(reason);
        return std::nullopt;
    };
    if (!is_number || (plus && digits.starts_with('-'))) {
        return refuse("is no number; numbers look like -1.5 or 2e-3");
    }
    if (read.ec == std::errc::result_out_of_range) {
        if (!is_tiny(digits)) return refuse("is too large a number");
        return digits.starts_with('-') ? -Real{0} : Real{0};
    }
    if (!std::isfinite(number)) return refuse("is not a finite number");
    return number;
}

template std::optional<float> parse_number(std::string_view, std::string&);
template std::optional<double> parse_number(std::string_view, std::string&);

}  // namespace pectin

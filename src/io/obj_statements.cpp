#include "io/obj_statements.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace pectin {
namespace {

constexpr std::string_view kBlanks = " \t";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

// Whether a decimal number that no Real can hold is so because it is tiny, not huge. Coarse:
// counts the digits before the first that is not 0, for such numbers are hundreds of them away.
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

}  // namespace

ObjStatements::ObjStatements(std::string_view text) : rest_(text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

std::string_view ObjStatements::take_line() {
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
    const std::string_view line = rest_.substr(0, end);
    const bool two = rest_.substr(end).starts_with("\r\n");
    rest_.remove_prefix(std::min(rest_.size(), end + (two ? 2 : 1)));
    ++lines_taken_;
    return line;
}

std::string_view ObjStatements::joined_with_continuations(std::string_view line) {
    joined_.clear();
    while (line.ends_with('\\')) {
        joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
        line = rest_.empty() ? std::string_view{} : take_line();
    }
    joined_.append(line);
    return joined_;
}

bool ObjStatements::next() {
    while (!rest_.empty()) {
        line_ = lines_taken_ + 1;
        std::string_view statement = take_line();
        const std::size_t begin = statement.find_first_not_of(kBlanks);
        if (begin == std::string_view::npos || statement[begin] == '#') continue;
        if (statement.ends_with('\\')) statement = joined_with_continuations(statement);

        statement = trimmed(statement);
        const std::size_t end = std::min(statement.find_first_of(kBlanks), statement.size());
        keyword_ = statement.substr(0, end);
        arguments_ = trimmed(statement.substr(end));
        if (!keyword_.empty()) return true;
    }
    return false;
}

std::optional<std::string_view> take_token(std::string_view& arguments) {
    const std::size_t begin = arguments.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos || arguments[begin] == '#') return std::nullopt;
    arguments.remove_prefix(begin);
    const std::size_t end = std::min(arguments.find_first_of(kBlanks), arguments.size());
    const std::string_view token = arguments.substr(0, end);
    arguments.remove_prefix(end);
    return token;
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
        why_not = "'" + std::string(token) + "' " + std::string(reason);
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

// Splits an OBJ text into statements, tokens and numbers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pectin {

// Splits a text into statements. Lines end with \n, \r\n or \r. A backslash at the end of a line
// continues the statement on the next line. Empty lines and lines that begin with # are skipped,
// but not #MRGB, with which ZBrush writes colours. A byte order mark is skipped.
class ObjStatements {
  public:
    // Precondition: `text` outlives this object.
    explicit ObjStatements(std::string_view text);

    // Moves to the next statement. Returns false at the end.
    bool next();

    // These describe the current statement. The views are valid until the next call of next().
    std::string_view keyword() const { return keyword_; }
    std::string_view arguments() const { return arguments_; }  // without leading or trailing blanks
    std::size_t line() const { return line_; }                 // of its first line, counted from 1

    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  private:
    std::string_view take_line();
    std::string_view joined_with_continuations(std::string_view line);

    const char* at_;
    const char* end_;
    const char* newline_;  // the first \n at or after at_, or end_; stale once at_ has passed it
    std::size_t lines_taken_ = 0;
    std::size_t line_ = 0;
    std::string joined_;
    std::string_view keyword_, arguments_;
};

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Removes the next token from the front of `arguments`. Returns nothing at the end or if the token
// begins with #. A plain loop, because find_first_of and memchr are slower on short tokens.
inline std::optional<std::string_view> take_token(std::string_view& arguments) {
    const std::size_t size = arguments.size();
    std::size_t begin = 0;
    while (begin < size && is_blank(arguments[begin])) ++begin;
    if (begin == size || arguments[begin] == '#') {
        arguments.remove_prefix(begin);
        return std::nullopt;
    }
    std::size_t end = begin + 1;
    while (end < size && !is_blank(arguments[end])) ++end;
    const std::string_view token = arguments.substr(begin, end - begin);
    arguments.remove_prefix(end);
    return token;
}

// The Real nearest to the decimal number `token`. A leading + is allowed. Numbers that are too
// small become 0. For anything else, including nan and infinities, returns nothing and sets
// `why_not`.
template <typename Real>
std::optional<Real> parse_number(std::string_view token, std::string& why_not);

extern template std::optional<float> parse_number(std::string_view, std::string&);
extern template std::optional<double> parse_number(std::string_view, std::string&);

// Reads at most n numbers from the front of `text` and returns how many there are. Returns nothing
// if one of them is not a finite number.
template <typename Real, std::size_t n>
std::optional<std::size_t> read_numbers(std::string_view text, std::array<Real, n>& numbers) {
    std::string why_not;
    for (std::size_t i = 0; i < n; ++i) {
        const auto token = take_token(text);
        if (!token) return i;
        const std::optional<Real> number = parse_number<Real>(*token, why_not);
        if (!number) return std::nullopt;
        numbers[i] = *number;
    }
    return n;
}

}  // namespace pectin

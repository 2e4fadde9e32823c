// The statements of an OBJ text, one by one, and the tokens and numbers in them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pectin {

// Splits a text into statements. Lines end with \n, \r\n or \r; a backslash at the end of a line
// continues it on the next; lines that are empty or begin with # are none, but for #MRGB, with
// which ZBrush writes colours. A byte order mark is skipped.
class ObjStatements {
  public:
    // Precondition: `text` outlives this.
    explicit ObjStatements(std::string_view text);

    // To the next statement; false at the end.
    bool next();

    // Of the present statement. Views hold until the next call of next().
    std::string_view keyword() const { return keyword_; }
    std::string_view arguments() const { return arguments_; }  // without blanks at the ends
    std::size_t line() const { return line_; }                 // from 1, of its first line

    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  private:
    std::string_view take_line();
    std::string_view joined_with_continuations(std::string_view line);

    const char* at_;
    const char* end_;
    const char* newline_;  // the first \n from at_ on, or end_; found anew once at_ is past it
    std::size_t lines_taken_ = 0;
    std::size_t line_ = 0;
    std::string joined_;
    std::string_view keyword_, arguments_;
};

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

// The next token, cut off the front of `arguments`; none at the end or at a # that begins one.
// By hand: most of a model is blanks and short tokens, too short for find_first_of and memchr.
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

// The Real nearest to the decimal number that `token` is; a leading + is allowed and what is too
// small is 0. For anything else, nan and infinities among it, returns none and says why.
template <typename Real>
std::optional<Real> parse_number(std::string_view token, std::string& why_not);

extern template std::optional<float> parse_number(std::string_view, std::string&);
extern template std::optional<double> parse_number(std::string_view, std::string&);

// Reads at most n numbers from the front of `text`; how many there are. None where one of these is
// not a finite number.
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

// The corners of OBJ faces, lines and points, and what their indices refer to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pectin {

// A corner as the file has it: indices from 1, or from the end where negative; 0 where none.
struct ObjCorner {
    // An index of a texture coordinate or normal that no file can have: 0, or too large a number.
    static constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::max();

    std::int32_t position = 0, uv = 0, normal = 0;
};

// Reads v, v/vt, v//vn or v/vt/vn with decimal indices; slashes with nothing behind them are seen
// in files. A position's index is not 0. For anything else returns none and says why.
std::optional<ObjCorner> parse_corner(std::string_view token, std::string& why_not);

// The same for the first corner in [at, end), where it is v, v/vt, v//vn or v/vt/vn of positive
// indices of at most nine digits and a blank follows it; moves `at` behind it. False for all
// others, which it does not judge. Most corners are such, and most of a model is corners.
inline bool take_plain_corner(const char*& at, const char* end, ObjCorner& corner) {
    const char* p = at;
    const auto take_index = [&p, end](std::int32_t& index) {
        constexpr std::ptrdiff_t kMostDigits = 9;
        const char* const begin = p;
        std::uint32_t number = 0;
        for (; p != end && *p >= '0' && *p <= '9'; ++p) {
            number = 10 * number + static_cast<std::uint32_t>(*p - '0');
        }
        index = static_cast<std::int32_t>(number);
        return p - begin <= kMostDigits && number != 0;
    };
    corner = {};
    if (!take_index(corner.position)) return false;
    if (p != end && *p == '/') {
        ++p;
        if (p != end && *p != '/' && !take_index(corner.uv)) return false;
        if (p != end && *p == '/') {
            ++p;
            if (!take_index(corner.normal)) return false;
        }
    }
    if (p != end && *p != ' ') return false;
    at = p;
    return true;
}

// From the file's way of counting one kind of element to ours. What comes later in the file may be
// referred to, so the end of the file has the last word.
class ObjReferences {
  public:
    explicit ObjReferences(std::string what) : what_(std::move(what)) {}

    // The index from 0 that `raw` means where `count` elements have been read so far; for one that
    // goes back too far returns none and says why.
    std::optional<std::uint32_t> resolve(std::int32_t raw, std::size_t count, std::size_t line,
                                         std::string& why_not) {
        const auto number = static_cast<std::uint32_t>(raw);
        if (raw > 0 && number <= count) return number - 1;
        return raw > 0 ? resolve_forward(number, line) : resolve_back(raw, count, why_not);
    }

    struct Dangling {
        std::size_t line;
        std::string message;
    };
    // The first line that refers to more than the `count` elements that the file has.
    std::optional<Dangling> first_dangling(std::size_t count) const;
    // That line alone; 0 where there is none.
    std::size_t first_line_beyond(std::size_t count) const {
        const auto dangling = first_dangling(count);
        return dangling ? dangling->line : 0;
    }

  private:
    std::uint32_t resolve_forward(std::uint32_t number, std::size_t line);
    std::optional<std::uint32_t> resolve_back(std::int32_t raw, std::size_t count,
                                              std::string& why_not) const;

    // Wherever a line asks for more than all lines before it; so the first that asks for too much
    // is among them, whatever too much is.
    struct Forward {
        std::uint32_t number;  // from 1
        std::size_t line;
    };
    std::string what_;  // what is referred to, for messages
    std::vector<Forward> forward_;
};

}  // namespace pectin

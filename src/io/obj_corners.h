// Parses the corners of OBJ faces, lines and points and resolves their indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pectin {

// A corner as in the file. Indices count from 1, negative ones from the end; 0 means none.
struct ObjCorner {
    // Stands for an index of a texture coordinate or normal that is 0 or too large in the file.
    static constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::max();

    std::int32_t position = 0, uv = 0, normal = 0;
};

// Reads v, v/vt, v//vn or v/vt/vn with decimal indices. Trailing slashes, which some files have,
// are accepted. The index of a position must not be 0. For anything else returns nothing and sets
// `why_not`.
std::optional<ObjCorner> parse_corner(std::string_view token, std::string& why_not);

// Fast path of parse_corner(): reads the first corner in [at, end) if it is v, v/vt, v//vn or
// v/vt/vn with positive indices of at most nine digits and a blank or the end follows, and moves
// `at` behind it. False is inconclusive. Most corners are of this kind, and most of a file is
// corners.
inline bool take_plain_corner(const char*& at, const char* end, ObjCorner& corner) {
    const char* p = at;
    const auto take_index = [&p, end](std::int32_t& index) {
        constexpr std::ptrdiff_t kMaxDigits = 9;
        const char* const begin = p;
        std::uint32_t number = 0;
        for (; p != end && *p >= '0' && *p <= '9'; ++p) {
            number = 10 * number + static_cast<std::uint32_t>(*p - '0');
        }
        index = static_cast<std::int32_t>(number);
        return p - begin <= kMaxDigits && number != 0;
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

// Converts the file's indices of one kind of element to indices from 0. Corners may refer to
// elements that come later in the file, so indices that are too large are only known at its end.
class ObjReferences {
  public:
    explicit ObjReferences(std::string what) : what_(std::move(what)) {}

    // The index from 0 that `raw` means when `count` elements have been read. If it counts back too
    // far, returns nothing and sets `why_not`.
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
    // The first line with an index beyond `count`, the number of elements in the file.
    std::optional<Dangling> first_dangling(std::size_t count) const;
    // Only the number of that line; 0 if there is none.
    std::size_t first_line_beyond(std::size_t count) const {
        const auto dangling = first_dangling(count);
        return dangling ? dangling->line : 0;
    }

  private:
    std::uint32_t resolve_forward(std::uint32_t number, std::size_t line);
    std::optional<std::uint32_t> resolve_back(std::int32_t raw, std::size_t count,
                                              std::string& why_not) const;

    // The indices that are larger than all earlier ones. The first index beyond any count is among
    // them.
    struct Forward {
        std::uint32_t number;  // counted from 1
        std::size_t line;
    };
    std::string what_;  // the kind of element, for messages
    std::vector<Forward> forward_;
};

}  // namespace pectin

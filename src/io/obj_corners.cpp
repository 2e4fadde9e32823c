#include "io/obj_corners.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "io/printable.h"

namespace pectin {

std::optional<ObjCorner> parse_corner(std::string_view token, std::string& why_not) {
    const auto refuse = [&](std::string_view reason) {
        why_not = quoted_word(token) + " " + std::string(reason);
        return std::nullopt;
    };
    ObjCorner corner;
    std::int32_t* const fields[] = {&corner.position, &corner.uv, &corner.normal};
    const char* at = token.data();
    const char* const end = at + token.size();
    for (std::int32_t* field : fields) {
        if (field != fields[0]) {
            if (at == end) return corner;
            if (*at != '/') break;
            ++at;
            if (at == end || *at == '/') continue;
        }
        const auto read = std::from_chars(at, end, *field);
        if (read.ec == std::errc::invalid_argument) break;
        const bool is_position = field == fields[0];
        const bool is_too_large = read.ec == std::errc::result_out_of_range;
        if (is_position && is_too_large) return refuse("has an index that is too large");
        if (is_position && *field == 0) return refuse("has an index 0; they count from 1");
        if (is_too_large || *field == 0) *field = ObjCorner::kNowhere;
        at = read.ptr;
    }
    if (at != end) return refuse("is no corner; corners look like 1, 1/2, 1//3 or 1/2/3");
    return corner;
}

std::uint32_t ObjReferences::resolve_forward(std::uint32_t number, std::size_t line) {
    if (forward_.empty() || number > forward_.back().number) forward_.push_back({number, line});
    return number - 1;
}

std::optional<std::uint32_t> ObjReferences::resolve_back(std::int32_t raw, std::size_t count,
                                                         std::string& why_not) const {
    const auto back = static_cast<std::size_t>(-static_cast<std::int64_t>(raw));
    if (back > count) {
        why_not = what_ + " " + std::to_string(raw) + " does not exist; up to here " +
                  (count == 1 ? "is " : "are ") + std::to_string(count);
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(count - back);
}

std::optional<ObjReferences::Dangling> ObjReferences::first_dangling(std::size_t count) const {
    const auto beyond = std::find_if(forward_.begin(), forward_.end(),
                                     [&](const Forward& f) { return f.number > count; });
    if (beyond == forward_.end()) return std::nullopt;
    return Dangling{beyond->line, what_ + " " + std::to_string(beyond->number) +
                                      " does not exist; the file has " + std::to_string(count)};
}

}  // namespace pectin

#include "io/up_axis_hint.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>

namespace pectin {
namespace {

constexpr std::size_t kRead = 4096;  // bytes

// Words with one blank around each, so that they are not found within others.
constexpr std::array<std::string_view, 7> kSaysY{
    " y up ", " y is up ", " yup ", " up y ", " up axis y ", " upaxis y ", " up axis is y "};
constexpr std::array<std::string_view, 7> kSaysZ{
    " z up ", " z is up ", " zup ", " up z ", " up axis z ", " upaxis z ", " up axis is z "};
constexpr std::array<std::string_view, 8> kWritesY{" blender ",   " zbrush ",      " maya ",
                                                   " wings 3d ",  " 3ds max ",     " houdini ",
                                                   " cinema 4d ", " nomad sculpt "};
constexpr std::array<std::string_view, 2> kWritesZ{" freecad ", " openscad "};

// The words of all comments in small letters. All other characters become blanks.
std::string words_of_comments(std::string_view text) {
    std::string words = " ";
    bool is_comment = false, begins_line = true;
    for (const char c : text.substr(0, kRead)) {
        if (begins_line) is_comment = c == '#';
        begins_line = c == '\n' || c == '\r';
        const auto letter = static_cast<unsigned char>(c);
        if (is_comment && std::isalnum(letter) != 0) {
            words += static_cast<char>(std::tolower(letter));
        } else if (words.back() != ' ') {
            words += ' ';
        }
    }
    return words + ' ';
}

std::optional<UpAxis> find(const std::string& words, std::span<const std::string_view> for_y,
                           std::span<const std::string_view> for_z) {
    const auto has = [&words](std::string_view phrase) {
        return words.find(phrase) != std::string::npos;
    };
    const bool has_y = std::ranges::any_of(for_y, has), has_z = std::ranges::any_of(for_z, has);
    if (has_y == has_z) return std::nullopt;
    return has_y ? UpAxis::y : UpAxis::z;
}

}  // namespace

std::optional<UpAxis> up_axis_hint(std::string_view text) {
    const std::string words = words_of_comments(text);
    const std::optional<UpAxis> stated = find(words, kSaysY, kSaysZ);
    return stated ? stated : find(words, kWritesY, kWritesZ);
}

}  // namespace pectin

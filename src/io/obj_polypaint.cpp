#include "io/obj_polypaint.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "io/obj_statements.h"

namespace pectin {
namespace {

constexpr std::size_t kDigits = 8;  // per entry
constexpr std::uint32_t kUnmasked = 0xff;

Vec3f color_of(std::uint32_t entry) {
    const auto channel = [entry](int shift) {
        return static_cast<float>(entry >> shift & 0xffu) / 255.0f;
    };
    return {channel(16), channel(8), channel(0)};
}

}  // namespace

void ObjPolypaint::add(std::string_view hexadecimals, std::size_t line) {
    if (first_line_ == 0) first_line_ = line;
    const std::size_t entries = entries_.size();
    while (unreadable_.count == 0) {
        const auto word = take_token(hexadecimals);
        if (!word) return;
        if (!add_word(*word)) break;
    }
    if (unreadable_.count == 0) entries_.resize(entries);
    unreadable_.add(line);
}

// Returns false if the word does not consist of entries.
bool ObjPolypaint::add_word(std::string_view digits) {
    if (digits.size() % kDigits != 0) return false;
    for (; !digits.empty(); digits.remove_prefix(kDigits)) {
        std::uint32_t entry = 0;
        const char* const end = digits.data() + kDigits;
        const auto read = std::from_chars(digits.data(), end, entry, 16);
        if (read.ec != std::errc{} || read.ptr != end) return false;
        entries_.push_back(entry);
    }
    return true;
}

void ObjPolypaint::apply(std::vector<Vec3f>& colors, std::size_t vertices,
                         ReadReport& report) const {
    report.unreadable_paint = unreadable_;
    if (entries_.empty()) return;
    colors.resize(vertices, Vec3f{std::numeric_limits<float>::quiet_NaN()});
    const std::size_t painted = std::min(entries_.size(), vertices);
    for (std::size_t i = 0; i < painted; ++i) {
        if (std::isnan(colors[i].x)) colors[i] = color_of(entries_[i]);
        if (entries_[i] >> 24 != kUnmasked) report.masked_vertices.add(first_line_);
    }
    report.unpainted_vertices.add(first_line_, static_cast<std::uint32_t>(vertices - painted));
    report.surplus_paint.add(first_line_, static_cast<std::uint32_t>(entries_.size() - painted));
}

}  // namespace pectin

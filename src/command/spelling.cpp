// V. I. Levenshtein. Binary codes capable of correcting deletions, insertions, and reversals.
// Doklady Akademii Nauk SSSR 163 (1965).
#include "command/spelling.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "command/field_types.h"
#include "command/reference.h"

namespace pectin {

namespace {

constexpr std::size_t kMaxCompared = 20, kMaxDistance = 2;

// The Levenshtein distance, computed one row at a time (Levenshtein 1965).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = std::exchange(row[j + 1], std::min({row[j + 1] + 1, row[j] + 1, changed}));
        }
    }
    return row.back();
}

// The command whose name is nearest; null if none is near.
const CommandReference* nearest_command(std::string_view given) {
    if (given.size() > kMaxCompared) return nullptr;
    const auto distance = [given](const CommandReference& entry) {
        return edit_distance(given, entry.name);
    };
    const auto known = command_reference();
    const auto nearest =
        std::min_element(known.begin(), known.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    return distance(*nearest) <= kMaxDistance ? &*nearest : nullptr;
}

}  // namespace

std::string unknown_command(std::string_view given) {
    std::vector<std::string> names;
    for (const CommandReference& command : command_reference()) names.push_back(command.name);
    const CommandReference* const meant = nearest_command(given);
    return "unknown command" + (meant ? "; did you mean " + meant->name + "?" : std::string()) +
           "; known are " + field::listed(names, "and");
}

}  // namespace pectin

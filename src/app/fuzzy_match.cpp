#include "app/fuzzy_match.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pectin {
namespace {

constexpr int kLetter = 1, kInARow = 6, kWordBegin = 8;
constexpr int kImpossible = -1'000'000;

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lower(std::string_view text) {
    std::string all(text);
    std::ranges::transform(all, all.begin(), [](char c) { return lower(c); });
    return all;
}

bool begins_word(std::string_view text, std::size_t at) {
    return at == 0 || text[at - 1] == ' ' || text[at - 1] == '-';
}

}  // namespace

// best[j]: the best score of the letters of the query so far, with the last of them at j.
std::optional<int> match_score(std::string_view query, std::string_view text) {
    std::string letters = lower(query);
    std::erase(letters, ' ');
    const std::string all = lower(text);
    if (letters.empty()) return 0;
    std::vector<int> best(all.size(), kImpossible), next(all.size());
    for (std::size_t i = 0; i < letters.size(); ++i) {
        int before = i == 0 ? 0 : kImpossible;  // the best score with the letter before left of j
        for (std::size_t j = 0; j < all.size(); ++j) {
            int from = before;
            if (i > 0 && j > 0) {
                from = std::max(from, best[j - 1] + kInARow);
                before = std::max(before, best[j - 1]);
                from = std::max(from, before);
            }
            const int score = kLetter + (begins_word(all, j) ? kWordBegin : 0);
            next[j] = all[j] == letters[i] && from > kImpossible ? from + score : kImpossible;
        }
        std::swap(best, next);
    }
    const int most = all.empty() ? kImpossible : *std::ranges::max_element(best);
    if (most <= 0) return std::nullopt;
    constexpr int kPerLetter = 100;  // so that the length only decides between equals
    return most * kPerLetter - static_cast<int>(all.size());
}

bool contains_text(std::string_view text, std::string_view query) {
    return lower(text).find(lower(query)) != std::string::npos;
}

}  // namespace pectin

// Finding a name by some of its letters.
#pragma once

#include <optional>
#include <string_view>

namespace pectin {

// How well the text fits what a user has typed to find it: higher is better. Nothing if the letters
// of the query do not occur in the text in this order. Blanks in the query and the case of ASCII
// letters are ignored. Letters in a row and at the beginnings of words count more, and a shorter
// text is better than a longer one. An empty query fits everything. Cost: O(query * text).
std::optional<int> match_score(std::string_view query, std::string_view text);

// Whether the text contains the query, ignoring the case of ASCII letters.
bool contains_text(std::string_view text, std::string_view query);

}  // namespace pectin

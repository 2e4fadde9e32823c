#include "io/obj_keywords.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "io/printable.h"

namespace pectin {

bool is_obj_keyword(std::string_view word) {
    static constexpr auto kKeywords = std::to_array<std::string_view>(
        {"#MRGB",  "bevel",      "bmat",   "bsp",    "bzp",   "c_interp", "call",      "cdc",
         "cdp",    "con",        "csh",    "cstype", "ctech", "curv",     "curv2",     "d_interp",
         "deg",    "end",        "f",      "fo",     "g",     "hole",     "l",         "lod",
         "maplib", "mg",         "mtllib", "o",      "p",     "parm",     "res",       "s",
         "scrv",   "shadow_obj", "sp",     "stech",  "step",  "surf",     "trace_obj", "trim",
         "usemap", "usemtl",     "v",      "vn",     "vp",    "vt"});
    return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

std::string_view likely_obj_keyword(std::string_view word) {
    using Guess = std::pair<std::string_view, std::string_view>;
    static constexpr std::array kGuesses{
        Guess{"f", "f"},       Guess{"face", "f"},      Guess{"faces", "f"},
        Guess{"facet", "f"},   Guess{"polygon", "f"},   Guess{"triangle", "f"},
        Guess{"tri", "f"},     Guess{"quad", "f"},      Guess{"v", "v"},
        Guess{"vert", "v"},    Guess{"vertex", "v"},    Guess{"vertices", "v"},
        Guess{"point", "v"},   Guess{"vn", "vn"},       Guess{"n", "vn"},
        Guess{"normal", "vn"}, Guess{"vt", "vt"},       Guess{"uv", "vt"},
        Guess{"vtx", "v"},     Guess{"texcoord", "vt"}, Guess{"texture", "vt"}};
    std::string letters;
    for (char c : word.substr(0, 16)) {
        if (c == ':' || c == ',' || c == '=') break;  // some files have "f:" and "f,"
        letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    const auto guess = std::find_if(kGuesses.begin(), kGuesses.end(),
                                    [&](const Guess& g) { return g.first == letters; });
    return guess == kGuesses.end() ? std::string_view{} : guess->second;
}

void UnknownKeywords::add(std::string_view word, std::size_t line) {
    constexpr std::size_t kMaxWords = 16;
    constexpr std::size_t kMaxLength = 64;  // bytes; quoted_word() shows that a longer word is cut
    word = word.substr(0, kMaxLength);
    if (words_.size() == kMaxWords) return;
    const auto is_word = [&](const Word& known) { return known.word == word; };
    if (std::any_of(words_.begin(), words_.end(), is_word)) return;
    words_.push_back({std::string(word), line});
}

std::string UnknownKeywords::explanation() const {
    std::string text;
    for (const Word& word : words_) {
        const std::string_view likely = likely_obj_keyword(word.word);
        if (likely.empty()) continue;
        text += (text.empty() ? "" : "; ") + quoted_word(word.word) + " in line " +
                std::to_string(word.line) + " should be " + quoted_word(likely);
    }
    if (!text.empty() || words_.empty()) return text;
    return quoted_word(words_[0].word) + " in line " + std::to_string(words_[0].line) +
           " is no OBJ keyword";
}

}  // namespace pectin

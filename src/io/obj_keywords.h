// The keywords of OBJ files, and guesses at what other words are meant to be.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pectin {

// Whether the format has it, read by pectin or not: curves, free-form surfaces and display
// statements among them (Wavefront Technologies, The Advanced Visualizer, appendix B1).
bool is_obj_keyword(std::string_view word);

// v, vt, vn or f, where the word resembles one of these ("F", "vertex"); empty for other words.
std::string_view likely_obj_keyword(std::string_view word);

// The different words at the beginning of statements that are no keywords, and where they first
// stand. Remembers a few; a file has no more of them, or is no OBJ file.
class UnknownKeywords {
  public:
    void add(std::string_view word, std::size_t line);

    struct Word {
        std::string word;
        std::size_t line;
    };
    const std::vector<Word>& words() const { return words_; }
    // "'V' in line 1 should be 'v'; 'F' in line 4 should be 'f'": what to tell of a file without
    // faces. Where no guess is possible, that the first word is no keyword. Empty without words.
    std::string explanation() const;

  private:
    std::vector<Word> words_;
};

}  // namespace pectin

// Knows the keywords of OBJ files and guesses which keyword a misspelt word means.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pectin {

// Whether the format has this keyword. This includes statements that pectin does not read, such as
// curves, free-form surfaces and display attributes (Wavefront Technologies. The Advanced
// Visualizer, appendix B1: Object files).
bool is_obj_keyword(std::string_view word);

// The keyword v, vt, vn or f that the word resembles ("F", "vertex"); empty for other words.
std::string_view likely_obj_keyword(std::string_view word);

// Collects the words at the beginning of statements that are not keywords, and the lines where they
// first occur. Keeps 16 words; a file with more is not an OBJ file.
class UnknownKeywords {
  public:
    void add(std::string_view word, std::size_t line);

    struct Word {
        std::string word;
        std::size_t line;
    };
    const std::vector<Word>& words() const { return words_; }
    // Explains why a file may have no faces: "'V' in line 1 should be 'v'; 'F' in line 4 should be
    // 'f'". If no guess is possible, says that the first word is no keyword. Empty without words.
    std::string explanation() const;

  private:
    std::vector<Word> words_;
};

}  // namespace pectin

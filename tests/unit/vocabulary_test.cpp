// Words that this project once used for things that have a name in the field. docs/glossary.md has
// the names. Each line of src/ and tests/ is read against the list, so that they do not come back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/paths.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

struct Retired {
    std::string words;    // one word, or several separated by spaces, in lower case
    std::string instead;  // what to write
    std::string except;   // the one file that may use it, or empty
};

const std::vector<Retired>& retired_words() {
    static const std::string kSimd = "src/ffd/drag_kernels.inl";  // elements of a SIMD vector
    static const std::vector<Retired> kTable{
        {"lane", "partition", kSimd},
        {"lanes", "partitions", kSimd},
        {"looks_fine", "satisfies_criteria_fast", ""},
        {"one_look", "is_smooth", ""},
        {"look_round", "classify_one_ring", ""},
        {"edgelooks", "EdgeClassifier", ""},
        {"freedplaces", "FreedSlots", ""},
        {"split_apart", "concurrent_split", ""},
        {"unsplit_apart", "concurrent_unsplit", ""},
        {"push_into_room", "push_back_unchecked", ""},
        {"grow_into_room", "grow_unchecked", ""},
        {"goes_next", "may_split_now", ""},
        {"lets_go", "face_allows", ""},
        {"is_let_go", "both_faces_allow", ""},
        {"let go", "dropped, deferred or released", ""},
        {"lets go", "drops, defers or releases", ""},
        {"letting go", "dropping, deferring or releasing", ""},
        {"in_hand", "active", ""},
        {"in hand", "active", ""},
        {"grip", "handle", ""},
        {"grips", "handles", ""},
        {"unplaced", "not yet embedded", ""},
        {"leader", "representative", ""},
        {"stretch_bound", "lipschitz_bound", ""},
        {"octave", "length class", ""},
        {"octaves", "length classes", ""},
        {"thinned", "decimated", ""},
        {"thinning", "decimation", ""},
        {"thins", "decimates", ""},
        {"cut through", "intersect", ""},
        {"hang together", "are connected", ""},
        {"hangs together", "is connected", ""},
        {"greissmair", "Griessmair", ""},
        {"greissmayr", "Griessmair", ""},
    };
    return kTable;
}

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

struct Word {
    std::string text;  // in lower case, without the underscore that ends the name of a member
    int line = 1;
};

std::vector<Word> words_of(std::string_view text) {
    std::vector<Word> words;
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '\n') ++line;
        const std::size_t first = i;
        while (i < text.size() && is_word_character(text[i])) ++i;
        if (i == first) {
            ++i;
            continue;
        }
        std::string word(text.substr(first, i - first));
        std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
        while (word.ends_with('_')) word.pop_back();
        words.push_back({word, line});
    }
    return words;
}

// One line for each retired word in the text of the file at `path`, relative to the repository. A
// phrase is found across the end of a line, too.
std::vector<std::string> complaints(const std::string& path, std::string_view text) {
    std::vector<std::string> found;
    const std::vector<Word> words = words_of(text);
    for (const Retired& retired : retired_words()) {
        if (path == retired.except) continue;
        const std::vector<Word> phrase = words_of(retired.words);
        for (auto at = words.begin();; ++at) {
            at = std::search(at, words.end(), phrase.begin(), phrase.end(),
                             [](const Word& a, const Word& b) { return a.text == b.text; });
            if (at == words.end()) break;
            found.push_back(path + ":" + std::to_string(at->line) + ": \"" + retired.words +
                            "\" is retired; write: " + retired.instead);
        }
    }
    return found;
}

bool is_text(const fs::path& path) {
    static const std::set<std::string> kExtensions{".h", ".cpp", ".inl", ".txt", ".cmake", ".py"};
    return kExtensions.contains(path.extension().string());
}

TEST(Vocabulary, HasNoRetiredWords) {
    const fs::path root = test::source_path("");
    int files = 0;
    for (const char* folder : {"src", "tests"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string path = entry.path().lexically_relative(root).generic_string();
            if (!entry.is_regular_file() || !is_text(entry.path())) continue;
            if (path == "tests/unit/vocabulary_test.cpp") continue;
            ++files;
            std::ifstream file(entry.path());
            ASSERT_TRUE(file) << path;
            const std::string text(std::istreambuf_iterator<char>(file), {});
            for (const std::string& complaint : complaints(path, text)) {
                ADD_FAILURE() << complaint;
            }
        }
    }
    EXPECT_GT(files, 200) << "under " << root << "; was anything read?";
}

TEST(Vocabulary, FindsWholeWordsInAnyCaseAndPhrasesAcrossLines) {
    EXPECT_EQ(complaints("src/adapt/a.h", "// The Lane of\n// an edge, in\n// hand.").size(), 2u);
    EXPECT_EQ(complaints("src/adapt/a.h", "std::vector<Edge> lanes_;").size(), 1u);
    EXPECT_TRUE(complaints("src/adapt/a.h", "// Planes, agripped, in the hand").empty());
    EXPECT_TRUE(complaints("src/ffd/drag_kernels.inl", "// lane i of the vector").empty());
}

}  // namespace
}  // namespace pectin

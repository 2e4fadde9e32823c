// The documents name files, folders and functions. What they name has to exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "support/paths.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = test::source_path("");

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

// All first groups of the expression in the text.
std::vector<std::string> matches(const std::string& text, const std::regex& expression) {
    std::vector<std::string> found;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), expression);
         at != std::sregex_iterator(); ++at) {
        found.push_back((*at)[1]);
    }
    return found;
}

// The names in `backticks` that have the form of a source file with its folder.
std::vector<std::string> source_files(const std::string& text) {
    static const std::regex kFile(R"(`([\w./]+/\w+\.(?:h|cpp|inl))`)");
    return matches(text, kFile);
}

// A document names files of src/ without that folder, and perhaps without the module that the
// sentence is about. Returns an empty path if there is no such file.
fs::path find(const std::string& name) {
    std::vector<fs::path> folders{kRoot, kRoot / "src"};
    for (const fs::directory_entry& module : fs::directory_iterator(kRoot / "src")) {
        folders.push_back(module.path());
    }
    const auto folder = std::ranges::find_if(
        folders, [&](const fs::path& candidate) { return fs::exists(candidate / name); });
    return folder == folders.end() ? fs::path{} : *folder / name;
}

std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    for (std::size_t first = 1, end = 0; (end = row.find('|', first)) != row.npos;
         first = end + 1) {
        cells.push_back(row.substr(first, end - first));
    }
    return cells;
}

// The last identifiers of the names in `backticks`: `Refiner::split` gives split.
std::vector<std::string> functions(const std::string& cell) {
    static const std::regex kName(R"(`(?:\w+::)*(\w+)(?:\([\w:]*\))?`)");
    return matches(cell, kName);
}

// One line for each function in the tables with the columns "file" and "function" that is in none
// of the files of its row.
std::vector<std::string> misplaced_functions(const std::string& document) {
    std::vector<std::string> wrong;
    std::size_t file_column = 0;  // 0: the table has none
    for (std::size_t first = 0, end = 0; first < document.size(); first = end + 1) {
        end = std::min(document.find('\n', first), document.size());
        const std::string line = document.substr(first, end - first);
        const std::vector<std::string> cells =
            line.starts_with('|') ? cells_of(line) : std::vector<std::string>{};
        if (cells.empty()) file_column = 0;
        if (file_column > 0 && file_column + 1 < cells.size()) {
            std::string sources;
            for (const std::string& name : source_files(cells[file_column])) {
                if (const fs::path path = find(name); !path.empty()) sources += text_of(path);
            }
            for (const std::string& name : functions(cells[file_column + 1])) {
                if (sources.empty() ||
                    std::regex_search(sources, std::regex("\\b" + name + "\\b"))) {
                    continue;
                }
                wrong.push_back(name + " is not in" + cells[file_column]);
            }
        }
        const auto header = std::ranges::find(cells, " file ");
        if (header != cells.end()) {
            file_column = static_cast<std::size_t>(header - cells.begin());
        }
    }
    return wrong;
}

TEST(Documents, NameFilesThatExist) {
    static const std::regex kLink(R"(\]\(([\w./-]+)\))");
    for (const char* name : {"README.md", "CONTRIBUTING.md", "docs/architecture.md",
                             "docs/glossary.md", "docs/CHANGELOG.md"}) {
        const fs::path path = kRoot / name;
        const std::string text = text_of(path);
        for (const std::string& link : matches(text, kLink)) {
            EXPECT_TRUE(fs::exists(path.parent_path() / link)) << name << ": " << link;
        }
        for (const std::string& file : source_files(text)) {
            EXPECT_FALSE(find(file).empty()) << name << ": " << file;
        }
    }
}

TEST(Documents, NameFunctionsThatAreInTheirFiles) {
    const std::string text = text_of(kRoot / "docs/architecture.md");
    for (const std::string& wrong : misplaced_functions(text)) ADD_FAILURE() << wrong;
    EXPECT_EQ(misplaced_functions("| what | file | function |\n|---|---|---|\n"
                                  "| x | `mesh/split.cpp` | `TriMesh::connect_left`, `f` |\n"),
              std::vector<std::string>{"f is not in `mesh/split.cpp` "});
}

}  // namespace
}  // namespace pectin

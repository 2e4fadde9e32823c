#include "command/script.h"

#include <filesystem>
#include <istream>
#include <type_traits>
#include <utility>

namespace pectin {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
// In bytes. Keeps a device or a damaged file from filling the memory. The longest sensible command,
// a drag of about 100,000 points, takes a tenth of this.
constexpr std::size_t kMaxLine = std::size_t{64} << 20;
constexpr const char* kBlanks = " \t\r\n\v\f";

// Whether the line is blank or a comment. Adds a comment to the ones before it, which a blank line
// ends.
bool is_skipped(const std::string& line, std::string& comment) {
    const auto first = line.find_first_not_of(kBlanks);
    if (first == line.npos) {
        comment.clear();
        return true;
    }
    if (line[first] != '#') return false;
    const auto begin = line.find_first_not_of(kBlanks, first + 1);
    if (begin == line.npos) return true;
    if (!comment.empty()) comment += ' ';
    comment += line.substr(begin, line.find_last_not_of(kBlanks) + 1 - begin);
    return true;
}

}  // namespace

std::optional<std::string> ScriptReader::read_line() {
    std::string line;
    ++number_;
    char next = 0;
    while (line.size() <= kMaxLine && text_.get(next) && next != '\n') line.push_back(next);
    if (!text_ && line.empty()) return std::nullopt;
    if (line.ends_with('\r')) line.pop_back();
    if (number_ == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
    return line;
}

std::optional<ScriptLine> ScriptReader::fail(std::string what) {
    is_done_ = true;
    return ScriptLine{number_, CommandError{"script", std::move(what)}};
}

std::optional<ScriptLine> ScriptReader::next() {
    std::string comment;
    while (!is_done_) {
        const std::optional<std::string> line = read_line();
        if (!line && text_.bad()) return fail("the script cannot be read on");
        if (line && line->size() > kMaxLine) {
            return fail(
                "the line is longer than 64 MiB, which is the most; a script has one command "
                "in each line");
        }
        if (number_ == 1) {
            const Done done = check_header(line.value_or(""));
            if (!done) return fail(done.refusal().reason);
        } else if (!line) {
            is_done_ = true;
        } else if (!is_skipped(*line, comment)) {
            return ScriptLine{number_, parse_command(*line), std::move(comment)};
        }
    }
    return std::nullopt;
}

void resolve_paths(Command& command, const std::string& folder) {
    std::visit(
        [&folder](auto& alternative) {
            if constexpr (requires { alternative.path; })
                alternative.path = (std::filesystem::path(folder) / alternative.path).string();
        },
        command);
}

}  // namespace pectin

#include "command/script.h"

#include <filesystem>
#include <istream>
#include <type_traits>

namespace pectin {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
// In bytes. Keeps a device or a damaged file from filling the memory. The longest sensible command,
// a drag of about 100,000 points, takes a tenth of this.
constexpr std::size_t kMaxLine = std::size_t{64} << 20;
constexpr const char* kBlanks = " \t\r\n\v\f";

bool is_skipped(const std::string& line) {
    const auto first = line.find_first_not_of(kBlanks);
    return first == line.npos || line[first] == '#';
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
        } else if (!is_skipped(*line)) {
            return ScriptLine{number_, parse_command(*line)};
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

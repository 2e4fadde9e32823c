#include "app/example.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>
#include <variant>

#include "app/command_kind.h"
#include "command/script.h"
#include "io/file_error.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

const char* file_name(Example example) {
    switch (example) {
        case Example::nose:
            return "nose.jsonl";
        case Example::elephant:
            return "elephant.jsonl";
        case Example::cage:
            return "cage.jsonl";
    }
    return "";
}

bool uses_files(const Command& command) {
    return is_any_of<command::Open, command::Save, command::Stats, command::Screenshot>(command);
}

}  // namespace

const char* title_of(Example example) {
    switch (example) {
        case Example::nose:
            return "A nose";
        case Example::elephant:
            return "An elephant";
        case Example::cage:
            return "A cage";
    }
    return "";
}

std::vector<fs::path> example_folders() {
    std::vector<fs::path> folders;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) folders.push_back(program.parent_path() / PECTIN_EXAMPLES_FROM_PROGRAM);
    folders.emplace_back(PECTIN_EXAMPLES_SOURCE);
    return folders;
}

std::vector<ExampleStep> read_example(const fs::path& script) {
    std::ifstream text(script, std::ios::binary);
    if (!text) throw FileError(script.string(), "the example cannot be read");
    std::vector<ExampleStep> steps;
    ScriptReader reader(text);
    while (std::optional<ScriptLine> line = reader.next()) {
        if (const auto* wrong = std::get_if<CommandError>(&line->command)) {
            throw FileError(script.string(), line->number, wrong->what);
        }
        Command& command = std::get<Command>(line->command);
        if (uses_files(command)) continue;
        if (steps.empty() || !line->comment.empty())
            steps.push_back({std::move(line->comment), {}});
        steps.back().commands.push_back(std::move(command));
    }
    return steps;
}

std::vector<ExampleStep> read_example(Example example, const std::vector<fs::path>& folders) {
    const std::string name = file_name(example);
    std::error_code ignored;
    const auto folder = std::ranges::find_if(
        folders, [&](const fs::path& candidate) { return fs::exists(candidate / name, ignored); });
    if (folder == folders.end()) throw FileError(name, "this example is not installed");
    return read_example(*folder / name);
}

std::vector<Vec3> drag_targets(const std::vector<ExampleStep>& steps) {
    std::vector<Vec3> targets;
    for (const ExampleStep& step : steps) {
        for (const Command& command : step.commands) {
            if (const auto* drag = std::get_if<command::Drag>(&command)) {
                for (const Move& move : drag->moves) targets.push_back(move.to);
            } else if (const auto* control = std::get_if<command::Control>(&command)) {
                for (const auto& point : control->points) targets.push_back(point.to);
            }
        }
    }
    return targets;
}

}  // namespace pectin

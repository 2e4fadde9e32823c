#include "app/command_line.h"

#include <CLI/CLI.hpp>

#include "command/reference.h"
#include "io/printable.h"

namespace pectin {

namespace {

constexpr const char* kUsage =
    "usage: pectin [MODEL.obj]     opens the window, on that model or on a sphere\n"
    "         --record FILE.jsonl  writes every command as it is done, as a script\n"
    "       pectin replay SCRIPT   executes a script (- reads it from standard input)\n"
    "       pectin --help          shows this and the commands of a script\n"
    "       pectin --version       shows the version\n";

std::string script_help() {
    std::string text =
        "A script is UTF-8 text. Its first line is {\"pectin\": 1}; blank lines and lines that\n"
        "start with # are ignored; each other line is one command with its fields, as in\n"
        "  {\"cmd\": \"drag\", \"moves\": [{\"from\": [0, 0, 1], \"to\": [0, 0, 1.3]}]}\n"
        "Relative paths are relative to the script. Angles are in degrees, lengths in the\n"
        "model's units, +y is up. The value in (brackets) is the default. A setting that is\n"
        "left out does not change. Replay stops at the first command that fails; files that\n"
        "earlier lines wrote are kept.\n";
    for (const CommandReference& command : command_reference()) {
        text += std::string("\n  ") + command.name + "  " + command.meaning + "\n";
        for (const FieldReference& field : command.fields) {
            std::string name = field.name;
            name.resize(std::max<std::size_t>(name.size(), 12), ' ');
            text += "      " + name + "  " + field.meaning + "\n";
        }
    }
    return text;
}

std::string help() {
    return std::string(
               "pectin is a sculpting program: the space around a dragged point behaves like "
               "jelly.\n\n") +
           kUsage + "\n" + script_help() +
           "\nExit status: 0 done; 1 a command failed, with SCRIPT:LINE: command: what is wrong\n"
           "and what would be right on standard error; 2 bad usage.\n";
}

CommandLine refuse(const std::string& why) {
    return {.action = CommandLine::Action::refuse,
            .text = "pectin: " + printable(why) + "\n" + kUsage};
}

}  // namespace

CommandLine read_command_line(int argc, char** argv) {
    CLI::App parser;
    parser.set_help_flag();  // help() is shown instead
    bool wants_help = false, wants_version = false;
    std::string script, model, record;
    parser.add_flag("-h,--help", wants_help);
    parser.add_flag("--version", wants_version);
    CLI::Option* record_option = parser.add_option("--record", record);
    parser.add_option("MODEL", model);
    CLI::App* replay = parser.add_subcommand("replay");
    replay->add_flag("-h,--help", wants_help);
    CLI::Option* script_option = replay->add_option("SCRIPT", script);
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return refuse(error.what());
    }
    if (wants_help) return {.action = CommandLine::Action::show, .text = help()};
    if (wants_version) {
        return {.action = CommandLine::Action::show, .text = "pectin " PECTIN_VERSION "\n"};
    }
    if (!replay->parsed()) {
        if (!record_option->empty() && record.empty()) return refuse("--record needs a file");
        return {.action = CommandLine::Action::window, .model = model, .record = record};
    }
    if (!model.empty() || !record_option->empty()) {
        return refuse("replay opens no window; give it a script and nothing else");
    }
    if (script_option->empty()) return refuse("replay needs the path of a script");
    return {.action = CommandLine::Action::replay, .script = script};
}

}  // namespace pectin

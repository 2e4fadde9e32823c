#include "app/command_line.h"

#include <CLI/CLI.hpp>

#include <utility>

#include "app/input_reference.h"
#include "command/reference.h"
#include "command/spelling.h"
#include "io/printable.h"

namespace pectin {

namespace {

constexpr const char* kUsage =
    "usage: pectin [MODEL.obj]     opens the window, on that model or on a sphere\n"
    "         --record FILE.jsonl  writes every command as it is done, as a script\n"
    "       pectin replay SCRIPT   executes a script (- reads it from standard input)\n"
    "       pectin help [COMMAND]  explains the commands of scripts and all their fields\n"
    "         --table              the same as a table in Markdown\n"
    "         --keys               what mouse and keys do in the window, as such a table\n"
    "       pectin schema          prints a JSON Schema of the lines of a script\n"
    "       pectin --help          shows this and the commands of a script\n"
    "       pectin --version       shows the version\n";

constexpr const char* kScript =
    "A script is UTF-8 text. Its first line is {\"pectin\": 1}; blank lines and lines that\n"
    "start with # are ignored; each other line is one command with its fields, as in\n"
    "  {\"cmd\": \"drag\", \"moves\": [{\"from\": [0, 0, 1], \"to\": [0, 0, 1.3]}]}\n"
    "Relative paths are relative to the script. Angles are in degrees, lengths in the\n"
    "model's units, +y is up. Replay stops at the first command that fails; files that\n"
    "earlier lines wrote are kept.\n";

std::string overview() {
    std::string text =
        "pectin is a sculpting program: the space around a dragged point behaves like jelly.\n\n";
    text += kUsage + std::string("\n") + kScript + "\nThe commands and their fields:\n";
    for (const CommandReference& command : command_reference()) {
        text += "  " + command.name;
        const char* separator = "  ";
        for (const FieldReference& field : command.fields) {
            text += separator + field.name;
            separator = ", ";
        }
        text += '\n';
    }
    return text +
           "pectin help COMMAND says what they mean.\n\n"
           "Exit status: 0 done; 1 a command failed, with SCRIPT:LINE: command: what is wrong\n"
           "and what would be right on standard error; 2 bad usage.\n";
}

std::string help_for_all() {
    std::string text = std::string(kScript) +
                       "The value in (brackets) is the default of a field; one without has to be "
                       "there. A\nsetting that is left out does not change.\n";
    for (const CommandReference& command : command_reference()) text += "\n" + help_text(command);
    return text;
}

CommandLine refuse(const std::string& why) {
    return {.action = CommandLine::Action::refuse,
            .text = "pectin: " + printable(why) + "\n" + kUsage};
}

CommandLine show(std::string text) {
    return {.action = CommandLine::Action::show, .text = std::move(text)};
}

// command: empty for all of them.
CommandLine show_help(const std::string& command, bool as_table) {
    if (as_table) return show(reference_table());
    if (command.empty()) return show(help_for_all());
    const CommandReference* const found = find_command(command);
    if (!found) return refuse(unknown_command(command));
    return show(help_text(*found));
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
    CLI::App* help = parser.add_subcommand("help");
    std::string command;
    bool as_table = false, lists_keys = false;
    help->add_option("COMMAND", command);
    help->add_flag("--table", as_table);
    help->add_flag("--keys", lists_keys);
    CLI::App* schema = parser.add_subcommand("schema");
    for (CLI::App* subcommand : {help, schema}) subcommand->add_flag("-h,--help", wants_help);
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return refuse(error.what());
    }
    if (wants_help) return show(overview());
    if (wants_version) return show("pectin " PECTIN_VERSION "\n");
    const bool opens_window = !model.empty() || !record_option->empty();
    if (opens_window && (help->parsed() || schema->parsed())) {
        return refuse("help and schema open no window; give them no model and no --record");
    }
    if (help->parsed() && as_table + lists_keys + !command.empty() > 1) {
        return refuse("give help either a command, --table for all commands, or --keys");
    }
    if (help->parsed() && lists_keys) return show(input_table());
    if (help->parsed()) return show_help(command, as_table);
    if (schema->parsed()) return show(json_schema());
    if (!replay->parsed()) {
        if (!record_option->empty() && record.empty()) return refuse("--record needs a file");
        return {.action = CommandLine::Action::window, .model = model, .record = record};
    }
    if (opens_window) {
        return refuse("replay opens no window; give it a script and nothing else");
    }
    if (script_option->empty()) return refuse("replay needs the path of a script");
    return {.action = CommandLine::Action::replay, .script = script};
}

}  // namespace pectin

// What the program was asked to do.
#pragma once

#include <string>

namespace pectin {

struct CommandLine {
    enum class Action { replay, show, refuse };
    Action action = Action::refuse;
    std::string script;  // to replay; "-" is standard input
    std::string text;    // to show (help, version), or why the usage is bad and what is right
};

CommandLine read_command_line(int argc, char** argv);

}  // namespace pectin

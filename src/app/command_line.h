// What the program was asked to do.
#pragma once

#include <string>

namespace pectin {

struct CommandLine {
    enum class Action { window, replay, show, refuse };
    Action action = Action::refuse;
    std::string script{};  // to replay; "-" is standard input
    std::string text{};    // to show (help, version), or why the usage is bad and what is right
    std::string model{};   // for the window to open; empty: none
    std::string record{};  // for the window to write its commands to; empty: none
};

CommandLine read_command_line(int argc, char** argv);

}  // namespace pectin

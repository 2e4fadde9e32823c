// Reads the command line.
#pragma once

#include <string>

namespace pectin {

struct CommandLine {
    enum class Action { window, replay, show, refuse };
    Action action = Action::refuse;
    std::string script{};  // path of the script to replay; "-" means standard input
    std::string text{};    // help or version to show, or why the usage is wrong and what is right
    std::string model{};   // path of the model that the window opens; empty: none
    std::string record{};  // path of the file to which the window writes its commands; empty: none
};

CommandLine read_command_line(int argc, char** argv);

}  // namespace pectin

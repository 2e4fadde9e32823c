// The examples of the menu Help: scripts that are installed with the program. The lines that start
// with # before a command are the caption of what follows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command/command.h"

namespace pectin {

enum class Example { nose, elephant, cage };

struct ExampleStep {
    std::string caption;
    std::vector<Command> commands;
};

const char* title_of(Example example);

// Where the scripts may be: first beside the installed program, then where the program was built.
std::vector<std::filesystem::path> example_folders();

// Reads a script. Each command with a caption begins a step, and so does the first one. Commands
// that use files (open, save, stats, screenshot) are left out, since an example only changes the
// object. Throws FileError if the script cannot be read or contains an error.
std::vector<ExampleStep> read_example(const std::filesystem::path& script);
// Finds the script in these folders and reads it. Throws FileError if it is in none of them.
std::vector<ExampleStep> read_example(Example example,
                                      const std::vector<std::filesystem::path>& folders);

// All points to which these steps drag something, for a view that shows them.
std::vector<Vec3> drag_targets(const std::vector<ExampleStep>& steps);

}  // namespace pectin

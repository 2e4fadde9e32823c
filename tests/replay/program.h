// Runs the program in its own folder.
#pragma once

#include <string>
#include <vector>

#include "support/scratch_folder.h"

namespace pectin {

// Writes a script with the first line and these commands into the folder, and returns its path.
std::string write_script(const ScratchFolder& folder, const std::string& name,
                         const std::vector<std::string>& lines);

struct Outcome {
    int exit_status = -1;  // -1 if a signal ended it
    std::string out, err;
};

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::string& standard_input = "");

}  // namespace pectin

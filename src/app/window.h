// The program's window.
#pragma once

#include <string>

#include "app/termination.h"

namespace pectin {

struct WindowOptions {
    std::string model{};   // path of the model to open; empty: a sphere
    std::string record{};  // path of the file to which all commands are written; empty: none
};

// Opens the window and returns when the user has closed it. Throws ContextError if no window can be
// opened, and FileError if the record cannot be written.
void run_window(const WindowOptions& options, TerminationWatch& termination);

}  // namespace pectin

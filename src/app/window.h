// The program's window, from its opening to its end.
#pragma once

#include <string>

#include "app/termination.h"

namespace pectin {

struct WindowOptions {
    std::string model{};   // to open; empty: a sphere
    std::string record{};  // file that gets every command as it is done; empty: none
};

// Returns when the person ends it. Throws ContextError where no window can be opened, FileError
// where the record cannot be written.
void run_window(const WindowOptions& options, TerminationWatch& termination);

}  // namespace pectin

// Does what a script says, without a window.
#pragma once

#include <iosfwd>
#include <string>

namespace pectin {

// Returns whether all of it was done. Stops at the first command that fails and writes to
// `errors` SCRIPT:LINE: command: what is wrong and what would be right. "-" reads standard input.
bool replay(const std::string& script_path, std::ostream& errors);

}  // namespace pectin

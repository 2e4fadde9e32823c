#include "command/command.h"

#include "command/reference.h"

namespace pectin {

const char* name(const Command& command) { return command_reference()[command.index()].name; }

}  // namespace pectin

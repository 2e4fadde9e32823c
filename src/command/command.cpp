#include "command/command.h"

#include "command/reference.h"

namespace pectin {

const char* name(const Command& command) {
    return command_reference()[command.index()].name.c_str();
}

}  // namespace pectin

// The settings of a new session, as commands.
#pragma once

#include <vector>

#include "command/command.h"

namespace pectin {

// Commands that reset all settings except the brush's radius and the cage. No command can say that
// these two are not set.
std::vector<Command> default_settings();

}  // namespace pectin

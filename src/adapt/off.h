// The value that switches a limit of adaptive meshing off.
#pragma once

#include <limits>

namespace pectin {

inline constexpr double kOff = std::numeric_limits<double>::infinity();

}  // namespace pectin

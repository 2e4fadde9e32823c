// Numbers as text, for messages and files.
#pragma once

#include <string>

#include "geometry/vec.h"

namespace pectin {

// The shortest decimal number that is read back as the same double.
std::string decimal(double number);
// "(x, y, z)"
std::string decimal(const Vec3& v);

}  // namespace pectin

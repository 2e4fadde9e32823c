// Numbers as text, for messages and files.
#pragma once

#include <string>

#include "geometry/vec.h"

namespace pectin {

// The shortest decimal that reads back as the same number.
std::string decimal(double number);
// "(x, y, z)"
std::string decimal(const Vec3& v);

}  // namespace pectin

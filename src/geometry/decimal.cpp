#include "geometry/decimal.h"

#include <array>
#include <charconv>

namespace pectin {

std::string decimal(double number) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}

std::string decimal(const Vec3& v) {
    return "(" + decimal(v.x) + ", " + decimal(v.y) + ", " + decimal(v.z) + ")";
}

}  // namespace pectin

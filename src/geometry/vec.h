// The vector types of the program: double for positions, float for normals and texture coordinates.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace pectin {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec3f = glm::vec3;
using Vec2f = glm::vec2;
using IVec3 = glm::ivec3;
using Mat3 = glm::dmat3;  // column-major: m[column][row]
using Mat3f = glm::mat3;

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The unit vector along v; zero if v has no direction (it is zero, or its square is not finite).
inline Vec3 unit_or_zero(const Vec3& v) {
    const double squared = glm::dot(v, v);
    const bool has_direction = squared > 0.0 && std::isfinite(squared);
    return has_direction ? v * (1.0 / std::sqrt(squared)) : Vec3{0.0};
}

}  // namespace pectin

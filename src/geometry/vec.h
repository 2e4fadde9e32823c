// Vectors of the whole program: double for positions, float for normals and texture coordinates.
#pragma once

#include <glm/glm.hpp>

namespace pectin {

using Vec3 = glm::dvec3;
using Vec3f = glm::vec3;
using Vec2f = glm::vec2;
using IVec3 = glm::ivec3;
using Mat3 = glm::dmat3;  // column-major: m[column][row]
using Mat3f = glm::mat3;

}  // namespace pectin

// The axis of a model that points upwards.
//
// Directions of views are given for models whose +y is up and whose front looks along +z.
// oriented() turns them for models whose +z is up; their front looks along -y, as in Blender.
#pragma once

#include <cstdint>

#include "geometry/vec.h"

namespace pectin {

enum class UpAxis : std::uint8_t { y, z };

// Turns a direction of a model with y up to the same direction of a model with this axis up.
inline Vec3 oriented(UpAxis up, const Vec3& direction) {
    if (up == UpAxis::y) return direction;
    return {direction.x, -direction.z, direction.y};
}
// The inverse of oriented().
inline Vec3 with_y_up(UpAxis up, const Vec3& direction) {
    if (up == UpAxis::y) return direction;
    return {direction.x, direction.z, -direction.y};
}
inline Vec3 up_vector(UpAxis up) {
    return up == UpAxis::y ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
}

}  // namespace pectin

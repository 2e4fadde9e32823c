// The cofactor matrix of a Jacobian, applied to a normal.
#pragma once

#include "geometry/vec.h"

namespace pectin {

// cof(J)·n without forming cof(J), whose columns are the cross products of the columns of J.
inline Vec3 cofactor_times(const Mat3& j, const Vec3& n) {
    return n.x * glm::cross(j[1], j[2]) + n.y * glm::cross(j[2], j[0]) +
           n.z * glm::cross(j[0], j[1]);
}

}  // namespace pectin

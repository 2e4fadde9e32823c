// The point relative to which ties between equally good diagonals are decided.
#pragma once

#include <span>

#include "geometry/vec.h"

namespace pectin {

// A choice that depends only on distances from this point along each axis is mirrored if the object
// is. On each axis the coordinate is 0, where the mirror plane of an object usually is, or the
// middle of the object's box if more points have a mirror image there. Cost: O(n) if the middle is
// 0, otherwise O(n log n).
Vec3 mirror_centre(std::span<const Vec3> points);

}  // namespace pectin

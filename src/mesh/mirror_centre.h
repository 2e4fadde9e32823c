// The point about which ties between equally good diagonals are decided.
#pragma once

#include <span>

#include "geometry/vec.h"

namespace pectin {

// A choice that depends on the distances from this point along each axis alone is mirrored where
// the object is. Per axis it is 0, where the object's mirror plane usually is, or the middle of the
// object's box if more of the points have a mirror image there. Cost: O(n) where the middle is 0,
// O(n log n) elsewhere.
Vec3 mirror_centre(std::span<const Vec3> points);

}  // namespace pectin

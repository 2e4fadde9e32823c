// The path of the cursor between two frames.
//
// D. H. Douglas, T. K. Peucker. Algorithms for the reduction of the number of points required to
// represent a digitized line or its caricature. Cartographica 10(2) (1973).
#pragma once

#include <vector>

#include "geometry/camera.h"

namespace pectin {

// Returns those points of `path` where it bends, and its last point. The polyline from `start`
// through them stays within `tolerance` of all other points. An empty path gives an empty result.
// Cost: O(n²) at worst, usually O(n log n).
// Source: Douglas & Peucker 1973.
std::vector<Vec2> simplified_path(const Vec2& start, const std::vector<Vec2>& path,
                                  double tolerance);

}  // namespace pectin

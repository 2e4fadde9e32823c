// The path of the cursor between two frames.
//
// D. H. Douglas, T. K. Peucker. Algorithms for the reduction of the number of points required to
// represent a digitized line or its caricature. Cartographica 10(2) (1973).
#pragma once

#include <span>
#include <vector>

#include "geometry/camera.h"

namespace pectin {

// Sets `kept` to those points of the path after its first where it bends, and its last point. The
// polyline from the first point through them stays within `tolerance` of all other points. A path
// of one point, or of none, keeps nothing. Cost: O(n²) at worst, usually O(n log n). Source:
// Douglas & Peucker 1973.
void simplify_path(std::span<const Vec2> path, double tolerance, std::vector<Vec2>& kept);

}  // namespace pectin

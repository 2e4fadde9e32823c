// The way of the cursor between two frames.
#pragma once

#include <vector>

#include "geometry/camera.h"

namespace pectin {

// The places of `path` that a line through `start` and them has to pass so that it stays within
// `tolerance` of all others: where it bends, and the last. Empty where the path is.
// Cost: O(n²) at worst, O(n log n) as a rule.
// Source: Douglas & Peucker, Algorithms for the Reduction of the Number of Points Required to
// Represent a Digitized Line or its Caricature, Cartographica 10(2), 1973.
std::vector<Vec2> bends(const Vec2& start, const std::vector<Vec2>& path, double tolerance);

}  // namespace pectin

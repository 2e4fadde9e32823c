// A simple polygon of the plane cut into triangles by a sweep.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/vec.h"
#include "mesh/ear_clipping.h"

namespace pectin {

struct SweptPolygon {
    std::vector<CornerTriangle> triangles;  // n - 2
    std::size_t steps = 0;                  // comparisons of corners with sides and with chains
};

// The triangles of a polygon whose corners are in counter-clockwise order. A line sweeps over the
// plane and parts the polygon into pieces that are monotone in x (D. T. Lee, F. P. Preparata.
// Location of a point in a planar subdivision and its applications. SIAM Journal on Computing 6
// (1977)); these are triangulated as they appear (M. R. Garey, D. S. Johnson, F. P. Preparata, R.
// E. Tarjan. Triangulating a simple polygon. Information Processing Letters 7 (1978)). All
// decisions are exact. Nothing where corners or sides are found to touch or to cross; then
// clip_ears may help. That is not always found: some triangles may turn clockwise then.
// Cost: O(n log n).
std::optional<SweptPolygon> sweep_triangles(std::span<const Vec2> points);

}  // namespace pectin

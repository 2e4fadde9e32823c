// Triangulates a simple plane polygon with a sweep line.
// Sources: D. T. Lee, F. P. Preparata. Location of a point in a planar subdivision and its
// applications. SIAM Journal on Computing 6 (1977). M. R. Garey, D. S. Johnson, F. P. Preparata,
// R. E. Tarjan. Triangulating a simple polygon. Information Processing Letters 7 (1978).
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

// Triangulates a polygon whose corners are in counter-clockwise order. The sweep divides it into
// pieces that are monotone in x (Lee & Preparata 1977), which are triangulated as they appear
// (Garey et al. 1978). All decisions are exact. Returns none if it finds that corners or sides
// touch or intersect. It does not always find this; some triangles may then be clockwise.
// Cost: O(n log n).
std::optional<SweptPolygon> sweep_triangles(std::span<const Vec2> points);

// Triangulates the polygon that results if each corner moves an infinitesimal distance along its
// direction (n of them). A triangle without area may then be one of the triangles.
std::optional<SweptPolygon> sweep_triangles(std::span<const Vec2> points,
                                            std::span<const Vec2> directions);

}  // namespace pectin

// A polygon of the plane cut into triangles by its ears.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace pectin {

using CornerTriangle = std::array<std::uint32_t, 3>;  // indices of a polygon's corners

struct FlatPolygon {
    std::vector<Vec2> points;          // counter-clockwise
    std::vector<Vec3> in_space;        // the same corners, for lengths
    std::vector<Vec3> in_plane;        // moved into the polygon's plane, for angles
    std::vector<std::uint32_t> order;  // n; ears of equal length are cut in ascending order of it
};

// n - 2 triangles whose sides are the polygon's and diagonals between its corners (G. H. Meisters.
// Polygons have ears. American Mathematical Monthly 82 (1975)), the shortest diagonal first. All
// decisions are exact. If no triangle turns clockwise, every point is covered as often as the
// polygon winds about it, so that the areas add up; this holds for every polygon that does not
// cross itself, also where it touches itself in corners or along bridges to holes. Others get the
// right number of triangles, of which some turn clockwise.
// Cost: O(n log n), and a search in a k-d tree for each of at most 4 n ears. Thin ears may make the
// trees' nodes that are visited in it many more than O(n log n): above `most_steps` of them there
// is no result.
std::vector<CornerTriangle> clip_ears(const FlatPolygon& polygon);
std::optional<std::vector<CornerTriangle>> clip_ears(const FlatPolygon& polygon,
                                                     std::size_t most_steps);

}  // namespace pectin

// Triangulates a plane polygon by ear clipping.
// Source: G. H. Meisters. Polygons have ears. American Mathematical Monthly 82 (1975).
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
    std::vector<Vec3> in_plane;        // the corners projected into the polygon's plane, for angles
    std::vector<std::uint32_t> order;  // n; the rank by which ears of equal length are ordered
};

// Returns n - 2 triangles whose sides are sides and diagonals of the polygon. Ears with short
// diagonals are cut first. All decisions are exact. If no triangle is clockwise, every point is
// covered as often as the polygon winds around it, so that the areas add up. This holds for every
// polygon that does not intersect itself, also if it touches itself in corners or along bridges to
// holes. Other polygons get the right number of triangles, some of them clockwise. Cost: O(n log
// n), and a search in a k-d tree for each of at most 4 n ears. Thin ears may make these searches
// visit many more than O(n log n) nodes; beyond `most_steps` nodes there is no result.
std::vector<CornerTriangle> clip_ears(const FlatPolygon& polygon);
std::optional<std::vector<CornerTriangle>> clip_ears(const FlatPolygon& polygon,
                                                     std::size_t most_steps);

// Polygons with more corners are large: their ears are searched with a limited number of steps.
constexpr std::size_t kMostCornersOfSmall = 1024;
// The most steps to give clip_ears() for a polygon of this many corners: of the order n log n, and
// without a limit for small polygons.
std::size_t most_ear_steps(std::size_t corners);

// Returns n - 2 triangles as above, but cuts off corners whether they are ears or not, those with
// short diagonals first. Some triangles are clockwise in most polygons that are not convex. Cost:
// O(n log n).
std::vector<CornerTriangle> clip_corners(const FlatPolygon& polygon);

}  // namespace pectin

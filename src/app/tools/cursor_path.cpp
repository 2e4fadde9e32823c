#include "app/tools/cursor_path.h"

#include <algorithm>
#include <cstddef>

namespace pectin {
namespace {

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = glm::dot(along, along);
    const double fraction =
        square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + fraction * along);
}

// Adds the points between positions[first] and positions[last] that have to be kept.
void add_kept_points(std::span<const Vec2> positions, std::size_t first, std::size_t last,
                     double tolerance, std::vector<Vec2>& kept) {
    std::size_t farthest = first;
    double distance = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double here = distance_to_segment(positions[i], positions[first], positions[last]);
        if (here <= distance) continue;
        farthest = i;
        distance = here;
    }
    if (farthest == first) return;
    add_kept_points(positions, first, farthest, tolerance, kept);
    kept.push_back(positions[farthest]);
    add_kept_points(positions, farthest, last, tolerance, kept);
}

}  // namespace

void simplify_path(std::span<const Vec2> path, double tolerance, std::vector<Vec2>& kept) {
    kept.clear();
    if (path.size() < 2) return;
    add_kept_points(path, 0, path.size() - 1, tolerance, kept);
    kept.push_back(path.back());
}

}  // namespace pectin

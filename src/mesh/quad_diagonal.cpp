#include "mesh/quad_diagonal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pectin {
namespace {

// All quantities here are bitwise equal for the mirrored quad and for any first corner: differences
// of mirrored coordinates are exact negatives, and sums and products commute. Quantities that
// differ by less than these tolerances count as equal nonetheless, since files round mirrored
// coordinates.
constexpr double kEqualLengths = 1e-6;    // relative, of squared lengths
constexpr double kEqualCosines = 1e-6;    // absolute
constexpr double kEqualDistances = 1e-3;  // relative to the longer diagonal

// A triangle with less than this share of the quad's area is a sliver.
constexpr double kSliver = 1e-3;
// Relative to the squared length of the diagonals. Smaller areas are rounding errors.
constexpr double kNoArea = 1e-12;

using Quad = std::array<Vec3, 4>;

// The quad's diagonal from corner `from` to corner from + 2.
struct Diagonal {
    Diagonal(const Quad& q, std::size_t start, const Vec3& normal)
        : from(start), along(q[start + 2] - q[start]), squared_length(glm::dot(along, along)) {
        // Each area is the mean of those computed at the two ends of the diagonal.
        const auto twice_area = [&](const Vec3& tip) {
            const Vec3 &a = q[start], &c = q[start + 2];
            return 0.5 * (glm::dot(glm::cross(along, tip - a), normal) +
                          glm::dot(glm::cross(along, tip - c), normal));
        };
        smaller_area = std::min(-twice_area(q[start + 1]), twice_area(q[(start + 3) % 4]));
    }

    std::size_t from;
    Vec3 along;
    double squared_length;
    double smaller_area;  // twice the smaller triangle's area, times the normal's length
};

// 2: both triangles are proper; 1: one is a sliver; 0: one has no area or faces the other way.
int shape_class(const Diagonal& d, const Vec3& normal) {
    if (d.smaller_area > kSliver * glm::dot(normal, normal)) return 2;
    return d.smaller_area > 0.0 ? 1 : 0;
}

double cosine_at(const Vec3& tip, const Vec3& p, const Vec3& q) {
    const Vec3 u = p - tip, v = q - tip;
    const double squares = glm::dot(u, u) * glm::dot(v, v);
    return squares > 0.0 ? glm::dot(u, v) / std::sqrt(squares) : 1.0;
}

// The cosine of the smallest angle of the two triangles.
double largest_cosine(const Quad& q, std::size_t from) {
    const Vec3 &a = q[from], &b = q[from + 1], &c = q[from + 2], &d = q[(from + 3) % 4];
    return std::max({cosine_at(a, b, c), cosine_at(a, c, d), cosine_at(b, a, c), cosine_at(d, a, c),
                     cosine_at(c, a, b), cosine_at(c, a, d)});
}

// Keeps the candidates whose value exceeds the least by at most `equal`.
template <typename Value>
void keep_least(std::array<bool, 4>& candidates, double equal, Value value) {
    double least = INFINITY;
    for (std::size_t i = 0; i < 4; ++i) {
        if (candidates[i]) least = std::min(least, value(i));
    }
    for (std::size_t i = 0; i < 4; ++i) {
        candidates[i] = candidates[i] && value(i) <= least + equal;
    }
}

// Whether the corner nearest to the mirror planes is 1 or 3.
bool nearest_corner_is_odd(const Quad& q, const Vec3& centre, double equal) {
    std::array<bool, 4> is_nearest{true, true, true, true};
    for (int axis = 0; axis < 3; ++axis) {
        keep_least(is_nearest, equal,
                   [&](std::size_t i) { return std::abs(q[i][axis] - centre[axis]); });
    }
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_decided =
            (is_nearest[0] || is_nearest[2]) != (is_nearest[1] || is_nearest[3]);
        if (is_decided) break;
        keep_least(is_nearest, equal, [&](std::size_t i) { return centre[axis] - q[i][axis]; });
    }
    return !is_nearest[0] && !is_nearest[2];
}

// Whether 1-3 is better than 0-2 if both are possible.
bool is_second_better(const Quad& q, const Diagonal& first, const Diagonal& second,
                      const Vec3& centre) {
    const double longer = std::max(first.squared_length, second.squared_length);
    const double difference = second.squared_length - first.squared_length;
    if (std::abs(difference) > kEqualLengths * longer) return difference < 0.0;
    const double cosines = largest_cosine(q, 1) - largest_cosine(q, 0);
    if (std::abs(cosines) > kEqualCosines) return cosines < 0.0;
    return nearest_corner_is_odd(q, centre, kEqualDistances * std::sqrt(longer));
}

}  // namespace

QuadDiagonal choose_diagonal(const Quad& corners, const Vec3& centre) {
    // Twice the area vector of the quad, which need not be flat.
    const Vec3 normal = glm::cross(corners[2] - corners[0], corners[3] - corners[1]);
    const Diagonal first(corners, 0, normal), second(corners, 1, normal);
    const int first_class = shape_class(first, normal), second_class = shape_class(second, normal);
    QuadDiagonal chosen;
    chosen.joins_1_and_3 = first_class != second_class
                               ? second_class > first_class
                               : is_second_better(corners, first, second, centre);
    if (std::max(first_class, second_class) == 0) {
        const double longer = std::max(first.squared_length, second.squared_length);
        const double size = glm::length(normal);
        const double area = std::max(glm::length(glm::cross(first.along, corners[1] - corners[0])),
                                     glm::length(glm::cross(first.along, corners[3] - corners[0])));
        const double worst = std::max(first.smaller_area, second.smaller_area);
        chosen.covers = area <= kNoArea * longer ||
                        (size > kNoArea * longer && worst >= -kNoArea * longer * size);
    }
    return chosen;
}

}  // namespace pectin

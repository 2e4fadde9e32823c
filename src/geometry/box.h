// Axis-aligned boxes, and the test of a triangle against one.
// Source: C. Ericson. Real-Time Collision Detection. Morgan Kaufmann 2005; T. Akenine-Möller. Fast
// 3D Triangle-Box Overlap Testing. Journal of Graphics Tools 6(1), 2001.
#pragma once

#include <limits>

#include "geometry/vec.h"

namespace pectin {

// A closed axis-aligned box. It is empty (min > max) until something is included.
struct Box {
    Vec3 min{std::numeric_limits<double>::infinity()};
    Vec3 max{-std::numeric_limits<double>::infinity()};

    bool is_empty() const { return min.x > max.x; }
    Vec3 centre() const { return 0.5 * min + 0.5 * max; }
    Vec3 extent() const { return is_empty() ? Vec3{0.0} : max - min; }
    double diagonal() const { return glm::length(extent()); }

    void include(const Vec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void include(const Box& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    bool meets(const Box& other) const {
        return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y &&
               other.min.y <= max.y && min.z <= other.max.z && other.min.z <= max.z;
    }
    bool contains(const Box& other) const {
        return min.x <= other.min.x && other.max.x <= max.x && min.y <= other.min.y &&
               other.max.y <= max.y && min.z <= other.min.z && other.max.z <= max.z;
    }
    bool contains(const Vec3& p) const {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && min.z <= p.z &&
               p.z <= max.z;
    }
    // For influenced zones, whose border does not move.
    bool contains_strictly(const Vec3& p) const {
        return min.x < p.x && p.x < max.x && min.y < p.y && p.y < max.y && min.z < p.z &&
               p.z < max.z;
    }
    // 0 for a point inside, and infinite for an empty box.
    double squared_distance(const Vec3& p) const {
        const Vec3 outside = glm::max(glm::max(min - p, p - max), Vec3{0.0});
        return glm::dot(outside, outside);
    }
    bool operator==(const Box&) const = default;
};

// The point of the closed triangle abc that is nearest to p (Ericson 2005, section 5.1.5).
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

// Whether the closed triangle abc and the closed box have a point in common. Precondition: no
// corner is in the box. Tests the separating axes of Akenine-Möller 2001: 3 of the box, the normal
// of the triangle, and 9 cross products.
bool sides_meet_box(const Vec3& a, const Vec3& b, const Vec3& c, const Box& box);

// Whether the closed triangle abc and the closed box have a point in common.
inline bool triangle_meets_box(const Vec3& a, const Vec3& b, const Vec3& c, const Box& box) {
    return box.contains(a) || box.contains(b) || box.contains(c) || sides_meet_box(a, b, c, box);
}

}  // namespace pectin

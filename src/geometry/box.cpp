#include "geometry/box.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pectin {
namespace {

// Whether the projections of the triangle and of the box (centred at 0) on `axis` are disjoint.
bool separates(const Vec3& axis, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& half) {
    const double pa = glm::dot(a, axis);
    const double pb = glm::dot(b, axis);
    const double pc = glm::dot(c, axis);
    const double reach = glm::dot(half, glm::abs(axis));
    return std::min({pa, pb, pc}) > reach || std::max({pa, pb, pc}) < -reach;
}

}  // namespace

bool triangle_meets_box(const Vec3& a, const Vec3& b, const Vec3& c, const Box& box) {
    Box bounds;
    bounds.include(a);
    bounds.include(b);
    bounds.include(c);
    if (!bounds.meets(box)) return false;
    if (box.contains(bounds)) return true;

    const Vec3 centre = box.centre();
    const Vec3 half = 0.5 * box.extent();
    Vec3 p = a - centre, q = b - centre, r = c - centre;
    // The same answer from whichever corner the triangle is told: the normal below rounds by order.
    const auto before = [](const Vec3& x, const Vec3& y) {
        return std::tie(x.x, x.y, x.z) < std::tie(y.x, y.y, y.z);
    };
    while (before(q, p) || before(r, p)) std::tie(p, q, r) = std::tuple(q, r, p);
    const Vec3 edges[3] = {q - p, r - q, p - r};
    if (separates(glm::cross(edges[0], edges[1]), p, q, r, half)) return false;
    for (const Vec3& edge : edges) {
        for (int i = 0; i < 3; ++i) {
            Vec3 unit{0.0};
            unit[i] = 1.0;
            if (separates(glm::cross(unit, edge), p, q, r, half)) return false;
        }
    }
    return true;
}

}  // namespace pectin

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

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3) return a + d1 / (d1 - d3) * ab;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4, along_bc = (d4 - d3) + (d5 - d6);
    if (va <= 0.0 && d4 >= d3 && d5 >= d6 && along_bc > 0.0) {
        return b + (d4 - d3) / along_bc * (c - b);
    }
    const double sum = va + vb + vc;
    return sum > 0.0 ? a + vb / sum * ab + vc / sum * ac : a;
}

bool sides_meet_box(const Vec3& a, const Vec3& b, const Vec3& c, const Box& box) {
    Box bounds;
    bounds.include(a);
    bounds.include(b);
    bounds.include(c);
    if (!bounds.meets(box)) return false;

    const Vec3 centre = box.centre();
    const Vec3 half = 0.5 * box.extent();
    Vec3 p = a - centre, q = b - centre, r = c - centre;
    // Starts with the least corner, since the rounding of the normal below depends on the order.
    // The answer is then the same for all three orders of the corners.
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

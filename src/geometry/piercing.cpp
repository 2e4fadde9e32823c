#include "geometry/piercing.h"

#include <algorithm>
#include <initializer_list>

#include "geometry/box.h"

namespace pectin {
namespace {

// Six times the volume of the tetrahedron abcd.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return glm::dot(glm::cross(b - a, c - a), d - a);
}

double squared(const Vec3& v) { return glm::dot(v, v); }

}  // namespace

bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double before = volume(a, b, c, p), after = volume(a, b, c, q);
    if (!((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0))) return false;
    const double ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    return (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
}

double squared_distance(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    const Vec3 u = q - p, v = s - r, w = p - r;
    const double uu = squared(u), vv = squared(v), uv = glm::dot(u, v), uw = glm::dot(u, w),
                 vw = glm::dot(v, w);
    // The nearest points of the two lines, each clamped to its segment.
    const double parallel = uu * vv - uv * uv;
    double along = parallel > 0.0 ? std::clamp((uv * vw - uw * vv) / parallel, 0.0, 1.0) : 0.0;
    double other = vv > 0.0 ? (uv * along + vw) / vv : 0.0;
    if (other < 0.0 || other > 1.0 || !(vv > 0.0)) {
        other = std::clamp(other, 0.0, 1.0);
        along = uu > 0.0 ? std::clamp((uv * other - uw) / uu, 0.0, 1.0) : 0.0;
    }
    return squared(w + along * u - other * v);
}

double squared_distance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    if (pierces(p, q, a, b, c)) return 0.0;
    return std::min({squared_distance(p, q, a, b), squared_distance(p, q, b, c),
                     squared_distance(p, q, c, a), squared(nearest_on_triangle(p, a, b, c) - p),
                     squared(nearest_on_triangle(q, a, b, c) - q)});
}

}  // namespace pectin

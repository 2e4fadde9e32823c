// Rays and their intersections with boxes and triangles.
// Source: S. Woop, C. Benthin, I. Wald. Watertight Ray/Triangle Intersection. Journal of Computer
// Graphics Techniques 2(1), 2013.
#pragma once

#include <limits>
#include <optional>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace pectin {

struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, -1.0};  // not zero; parameters are in units of its length

    Vec3 at(double t) const { return origin + t * direction; }
};

// The part of a ray inside something: origin + t * direction for t in [enter, leave].
struct RayInterval {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
};

// The part of the ray inside the closed box at t >= 0; nothing if the ray misses the box. Rounds
// outwards, so that a ray that hits a triangle also hits every box around it.
std::optional<RayInterval> intersect(const Ray& ray, const Box& box);

// The intersection of a ray with a triangle: origin + t * direction = u a + v b + w c.
struct RayHit {
    double t = 0.0;                    // at least 0
    double u = 0.0, v = 0.0, w = 0.0;  // barycentric, in [0, 1]
    bool from_outside = true;          // a, b, c are counter-clockwise seen from the origin
};

// Finds intersections with either side. A ray through an edge that triangles share hits at least
// one of them. Triangles without area and triangles seen edge-on are never hit. (Woop et al. 2013.)
std::optional<RayHit> intersect(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace pectin

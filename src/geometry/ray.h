// Rays and what they meet: boxes and triangles.
#pragma once

#include <limits>
#include <optional>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace pectin {

struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, -1.0};  // not 0; parameters count in its length

    Vec3 at(double t) const { return origin + t * direction; }
};

// The stretch of a ray inside something: origin + t * direction for t in [enter, leave].
struct RayInterval {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
};

// The part of the closed box that lies on the ray at t >= 0; nothing where it misses. Rounds
// outwards, so that a box never hides a triangle in it.
std::optional<RayInterval> intersect(const Ray& ray, const Box& box);

// Where a ray meets a triangle: origin + t * direction = u a + v b + w c.
struct RayHit {
    double t = 0.0;                    // at least 0
    double u = 0.0, v = 0.0, w = 0.0;  // barycentric, in [0, 1]
    bool from_outside = true;          // whether a, b, c run counter-clockwise seen by the ray
};

// Meets both sides. Of triangles that share an edge, a ray through the edge meets at least one;
// triangles of no area, or seen edge-on, are never met.
// Source: Woop, Benthin & Wald, Watertight Ray/Triangle Intersection, JCGT 2013.
std::optional<RayHit> intersect(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace pectin

// Segments and triangles: whether they intersect, and their distance.
// Source: C. Ericson. Real-Time Collision Detection. Morgan Kaufmann 2005.
#pragma once

#include "geometry/vec.h"

namespace pectin {

// Whether the open segment pq passes through the interior of the triangle abc. That is the case if
// its ends lie strictly on different sides of the plane, and the line passes all three edges on the
// same side.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

// The squared distance between the closed segments pq and rs (Ericson 2005, section 5.1.9). Either
// may be a point.
double squared_distance(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

// The squared distance between the closed segment pq and the closed triangle abc.
double squared_distance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace pectin

// Segments and triangles: whether one passes through the other, and how near they come.
#pragma once

#include "geometry/vec.h"

namespace pectin {

// Whether the open segment pq passes through the inside of the triangle abc: its ends are strictly
// on either side of the plane, and the line goes by all three edges on the same side.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

// The square of the distance between the closed segments pq and rs (Ericson, Real-Time Collision
// Detection, 2005, section 5.1.9); either may be a point.
double squared_distance(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

// The square of the distance between the closed segment pq and the closed triangle abc.
double squared_distance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace pectin

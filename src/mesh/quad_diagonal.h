// Which diagonal of a quad becomes an edge.
#pragma once

#include <array>

#include "geometry/vec.h"

namespace pectin {

struct QuadDiagonal {
    bool joins_1_and_3 = false;  // else corners 0 and 2
    bool covers = true;          // false: no diagonal leaves two triangles that face one way
};

// The choice does not depend on the first corner or on the orientation, and mirroring the quad in
// any axis through `centre` mirrors it. In this order:
//  1. the diagonal whose triangles face the quad's way and are no slivers;
//  2. the shorter one;
//  3. the one with the larger smallest angle;
//  4. the one that ends at the corner nearest to the mirror planes, x before y before z.
// A quad that is its own image across a plane which no corner is on has no diagonal that is its
// own image: there the corner on the positive side decides, so that its images in the other two
// axes still agree with it.
// Precondition: the corners are finite.
QuadDiagonal choose_diagonal(const std::array<Vec3, 4>& corners, const Vec3& centre);

}  // namespace pectin

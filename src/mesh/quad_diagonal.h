// Chooses the diagonal of a quad that becomes an edge.
#pragma once

#include <array>

#include "geometry/vec.h"

namespace pectin {

struct QuadDiagonal {
    bool joins_1_and_3 = false;  // else corners 0 and 2
    bool covers = true;          // false: with either diagonal the triangles face opposite ways
};

// The choice does not depend on the first corner or on the orientation, and mirroring the quad
// along any axis through `centre` mirrors the choice. Criteria, in this order:
//  1. the triangles face the same way as the quad and are no slivers;
//  2. the diagonal is shorter;
//  3. the smallest angle is larger;
//  4. the diagonal ends at the corner nearest to the mirror planes, x before y before z.
// A quad that is its own mirror image across a plane that contains none of its corners has no
// diagonal that is its own mirror image. There the corner on the positive side decides, so that the
// quad's images along the other two axes still agree.
// Precondition: the corners are finite.
QuadDiagonal choose_diagonal(const std::array<Vec3, 4>& corners, const Vec3& centre);

}  // namespace pectin

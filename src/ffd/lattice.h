// The control lattice: an axis-aligned grid of control points, and the zones that it deforms.
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999: section 2, figure 2.
#pragma once

#include <cstddef>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace pectin {

inline constexpr int kMinDeformable = 1;               // control points that may move, per axis
inline constexpr int kMaxDeformable = 256;             // at most half a gigabyte for all of them
inline constexpr int kMaxMargin = 2;                   // layers beyond a fitted box, on each side
inline constexpr int kMaxFitted = kMaxDeformable - 2;  // control points on a fitted box, per axis

// Control point (i, j, k) rests at origin + (i, j, k)∘cell in world space. The control points with
// 0 ≤ (i, j, k) < deformable may move; the phantom layer at −3 and deformable + 2 never moves.
//
//     −3    −2    −1     0     1    …    l−1    l    l+1   l+2
//   phantom  [— influenced —[ deformable zone ]— influenced —]  phantom
//
// The outermost `margin` layers of the deformable control points lie beyond the box that the others
// span. Users count only the control points on the box. The index that a user gives (i, j, k) is
// (i, j, k) − margin, so that (0, 0, 0) is the first one on the box.
struct Lattice {
    Vec3 origin{0.0};
    Vec3 cell{1.0};
    IVec3 deformable{1};
    IVec3 margin{0};

    // Whether the lattice is finite, with positive cells, and with counts and margins within the
    // limits above. This is a precondition of all other functions but ==.
    bool is_valid() const;

    // As users count: the number of control points per axis without the margins, and the indices of
    // the first and the last control point with the margins.
    IVec3 counts() const { return deformable - 2 * margin; }
    IVec3 first_index() const { return -margin; }
    IVec3 last_index() const { return deformable - 1 - margin; }
    IVec3 user_index(const IVec3& control) const { return control - margin; }
    IVec3 control_of_user_index(const IVec3& index) const { return index + margin; }

    // The deformable zone and two cells beyond it, in world space. Nothing moves on the border of
    // the influenced zone and outside.
    Box influenced_zone() const {
        return {.min = origin - 2.0 * cell, .max = origin + Vec3{deformable + 1} * cell};
    }
    // Tests the box itself, so that no rounding of a parameter moves a point on the border.
    bool influences(const Vec3& x) const { return influenced_zone().contains_strictly(x); }

    // From world to lattice space, in cells. Because of linear precision no other embedding is
    // needed.
    Vec3 parameter(const Vec3& x) const { return (x - origin) / cell; }
    Vec3 rest(const IVec3& control) const { return origin + Vec3{control} * cell; }

    double smallest_cell_extent() const { return glm::min(cell.x, glm::min(cell.y, cell.z)); }

    std::size_t control_count() const {
        return static_cast<std::size_t>(deformable.x) * static_cast<std::size_t>(deformable.y) *
               static_cast<std::size_t>(deformable.z);
    }
    // The index of a deformable control point in an array of all of them: i is fastest, k slowest.
    std::size_t control_index(const IVec3& control) const {
        const auto l = static_cast<std::size_t>(deformable.x);
        const auto m = static_cast<std::size_t>(deformable.y);
        return static_cast<std::size_t>(control.x) +
               l * (static_cast<std::size_t>(control.y) + m * static_cast<std::size_t>(control.z));
    }

    bool operator==(const Lattice&) const = default;
};

// The lattice of a brush. It has `span` control points per axis and is centred on the grabbed
// point, and its influenced zone reaches `radius` to each side: cell = radius / ((span − 1)/2 + 2).
// Preconditions: radius > 0, kMinDeformable ≤ span ≤ kMaxDeformable.
Lattice brush_lattice(const Vec3& centre, double radius, int span);

// The lattice whose control points span `box`, with `counts` of them per axis, the first at its min
// and the last at its max. On an axis with a single control point this point is in the middle, and
// the cell is half the extent. On an axis along which the box is flat the lattice is centred, and
// its cell is the largest one of the other axes, or 1 if there is none. One more layer of control
// points lies beyond the box on each side (two layers if the count is 1), so that all control
// points whose basis is not zero in the box may move. Since B-splines have linear precision, an
// affine map of all control points then maps the space in the box by exactly that map.
// Preconditions: the box is finite and not empty, counts from 1 to kMaxFitted.
Lattice fit_lattice(const Box& box, const IVec3& counts);

}  // namespace pectin

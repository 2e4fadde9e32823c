// The control lattice: an axis-aligned grid of control points and the zones it deforms.
// Source: Gain & Dodgson 1999, section 2, figure 2.
#pragma once

#include <cstddef>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace pectin {

inline constexpr int kMinDeformable = 1;    // control points that may move, per axis
inline constexpr int kMaxDeformable = 256;  // keeps a full set of them below half a gigabyte
inline constexpr int kMaxMargin = 2;        // layers beyond a fitted box, on each side
inline constexpr int kMaxFitted = kMaxDeformable - 2;  // control points on a fitted box, per axis

// Control point (i, j, k) rests at origin + (i, j, k)∘cell, in world space. Those with
// 0 ≤ (i, j, k) < deformable may move; the phantom layer at −3 and deformable + 2 never does.
//
//     −3    −2    −1     0     1    …    l−1    l    l+1   l+2
//   phantom  [— influenced —[ deformable zone ]— influenced —]  phantom
//
// The outermost `margin` layers of the deformable control points may lie beyond the box that the
// others span. Users count and number those on the box: the index of (i, j, k) for a user is
// (i, j, k) − margin, so that (0, 0, 0) is the first on the box.
struct Lattice {
    Vec3 origin{0.0};
    Vec3 cell{1.0};
    IVec3 deformable{1};
    IVec3 margin{0};

    // Finite, with positive cells, and counts and margins within the limits above; every other
    // function but == takes that for granted.
    bool is_valid() const;

    // As users count and number them: the deformable control points per axis without the margins,
    // and the indices of the first and the last with them.
    IVec3 counts() const { return deformable - 2 * margin; }
    IVec3 first_index() const { return -margin; }
    IVec3 last_index() const { return deformable - 1 - margin; }
    IVec3 user_index(const IVec3& control) const { return control - margin; }
    IVec3 control_of_user_index(const IVec3& index) const { return index + margin; }

    // World: two cells beyond the deformable zone. On its border and outside nothing moves.
    Box influenced_zone() const {
        return {.min = origin - 2.0 * cell, .max = origin + Vec3{deformable + 1} * cell};
    }
    // Decided on that very box, so no rounding of a parameter moves a point on its border.
    bool influences(const Vec3& x) const { return influenced_zone().contains_strictly(x); }

    // World to lattice space, in cells. By linear precision the embedding is the identity.
    Vec3 parameter(const Vec3& x) const { return (x - origin) / cell; }
    Vec3 rest(const IVec3& control) const { return origin + Vec3{control} * cell; }

    double smallest_cell_extent() const { return glm::min(cell.x, glm::min(cell.y, cell.z)); }

    std::size_t control_count() const {
        return static_cast<std::size_t>(deformable.x) * static_cast<std::size_t>(deformable.y) *
               static_cast<std::size_t>(deformable.z);
    }
    // Where a deformable control point stands in an array of them: i runs fastest, k slowest.
    std::size_t control_index(const IVec3& control) const {
        const auto l = static_cast<std::size_t>(deformable.x);
        const auto m = static_cast<std::size_t>(deformable.y);
        return static_cast<std::size_t>(control.x) +
               l * (static_cast<std::size_t>(control.y) + m * static_cast<std::size_t>(control.z));
    }

    bool operator==(const Lattice&) const = default;
};

// The lattice of a brush: `span` control points per axis, centred on the grabbed point, whose
// influenced zone reaches `radius` to every side: cell = radius / ((span − 1)/2 + 2).
// Preconditions: radius > 0, kMinDeformable ≤ span ≤ kMaxDeformable.
Lattice brush_lattice(const Vec3& centre, double radius, int span);

// The lattice whose control points span `box`: per axis `counts` of them, the first at its min and
// the last at its max. An axis with a single control point has it in the middle and a cell of half
// the extent; an axis along which the box is flat is centred on it and takes the largest cell of
// the other axes, or 1 where there is none. One more layer of control points lies beyond the box on
// each side (two where the count is 1), so that all those whose basis is not zero in the box may
// move. B-splines have linear precision: an affine map of all control points is then, in the box,
// that map of space. Preconditions: the box is finite and not empty, counts from 1 to kMaxFitted.
Lattice fit_lattice(const Box& box, const IVec3& counts);

}  // namespace pectin

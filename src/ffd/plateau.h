// The coefficients of a plateau: control points that move together with a handle.
//
// With k constraints whose rows are B, any coefficient vectors P, one column for each driven
// constraint, can be corrected to C = P + Bᵀ(BBᵀ)⁻¹(I − B P), so that B C = I: the field
// D(x) = Σ_c w_c(x) d_c with w(x) = Cᵀ b(x) meets all constraints exactly. P = 0 gives the smallest
// displacement of the control points. Here P is 1 on a block of control points around the handle.
// By partition of unity w is then 1 where all 64 control points that reach x belong to the block.
//
// Where the weight is one half a plateau is round within a percent. Where it ends it is not: the
// lattice ends along the axes, and control points at the rim of a ball are not at equal distances
// from its middle, so that with 7 control points per axis or more the outer line waves by some
// percent of the radius.
//
// The correction is the smallest one (W. M. Hsu, J. F. Hughes, H. Kaufman. Direct Manipulation of
// Free-Form Deformations. SIGGRAPH 1992: section 3, applied to the displacements that P leaves
// unmet). w is a spline of the same lattice, so that everything that is proven from its Bernstein
// coefficients holds as well.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ffd/constraint.h"
#include "ffd/lattice.h"
#include "ffd/symmetry.h"
#include "ffd/weight_spline.h"

namespace pectin {

class PlateauBlocks {
  public:
    // points: those of all handles and pins, without images; equal points may be repeated.
    PlateauBlocks(const Lattice& lattice, const std::optional<MirrorPlane>& plane,
                  std::span<const Vec3> points);

    // The coefficients for a driven constraint, one for each control point in the order of
    // control_index. The block of a handle is a ball that reaches the border of a lattice around it
    // and fades out over two cells, so that a plateau is about round; its top is nearly flat with 5
    // control points per axis or more. Where another handle or a pin is nearer, control points do
    // not belong to the block; neighbouring blocks meet without a gap. With a plane all blocks are
    // on the side of the plane where the middle of the lattice is, and the mirror image of the
    // lattice has the other half. For a derivative along an axis the coefficients are the distances
    // from the handle along this axis instead of 1, so that the block rotates or scales as a whole.
    // Cost: O(control points · points).
    std::vector<double> coefficients(const ConstraintKey& key) const;

  private:
    Vec3 on_own_side(const Vec3& point) const;
    double membership(const IVec3& control, const Vec3& handle) const;
    double nearness(const Vec3& control, const Vec3& handle) const;

    const Lattice& lattice_;
    std::optional<MirrorPlane> plane_;
    double side_ = 1.0;         // of the plane: the sign of the offset of the lattice's middle
    std::vector<Vec3> points_;  // on that side, in cells
};

// The columns of C for the first `driven` constraints, as weights. solve: returns the solution of
// the system with the matrix of dot(constraint, constraint) for a right side.
std::vector<WeightSpline> plateau_weights(
    const Lattice& lattice, const std::optional<MirrorPlane>& plane,
    std::span<const Constraint> constraints, std::size_t driven,
    const std::function<std::vector<double>(const std::vector<double>&)>& solve);

}  // namespace pectin

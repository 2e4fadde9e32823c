// The displacement field of a drag, linear in what is dragged: D(x) = Σ_c w_c(x) d_c.
// Source: W. M. Hsu, J. F. Hughes, H. Kaufman. Direct Manipulation of Free-Form Deformations.
// SIGGRAPH 1992, rearranged; J. Gain, N. Dodgson. Adaptive Refinement and Decimation under
// Free-Form Deformation. Eurographics UK 1999: equations 1 and 4–7.
//
// Let b(x) be the basis values of all control points at x, and B the rows of the constraints. Then
// D(x) = b(x)ᵀ Bᵀ(BBᵀ)⁻¹ d, so w(x) = (BBᵀ)⁻¹ B b(x) depends only on the rest position. A gesture
// evaluates w and ∇w once per vertex; a frame then uses the functions of ffd/drag_weight.h. Weights
// that are not the smallest solution are splines with explicit coefficients (ffd/plateau.h).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ffd/basis_row.h"
#include "ffd/drag_weight.h"
#include "ffd/lattice.h"
#include "ffd/weight_spline.h"

namespace pectin {

class DragField {
  public:
    // constraints: the rows of the constrained points, each of unit length. inverse: the rows of
    // (BBᵀ)⁻¹ that belong to the driven constraints, weight_count × constraints in row-major order,
    // such that w_c(x) = Σ_a inverse[c][a] · (row a · b(x)). DragSolver computes both.
    DragField(const Lattice& lattice, std::vector<BasisRow> constraints,
              std::vector<double> inverse);
    // The weights, at least one, as splines of the lattice.
    DragField(const Lattice& lattice, std::vector<WeightSpline> splines);

    const Lattice& lattice() const { return lattice_; }
    // The number of driven constraints, each of which has a weight w_c and a displacement d_c.
    std::size_t weight_count() const { return weight_count_; }

    // out: weight_count. Exactly zero on the border of the influenced zone and outside. Evaluated
    // in double and rounded once. Cost: about 40 multiplications for each constraint near x, and
    // four more for each pair of such a constraint and a weight; of splines 200 for each weight.
    void weights(const Vec3& x, std::span<DragWeight> out) const;

    // out: points × weight_count, all weights of a point together. Each point has bit for bit the
    // weights that the function above computes.
    void weights(std::span<const Vec3> points, std::span<DragWeight> out) const;

    // The weights from `first` on before rounding, for sums in which they cancel.
    struct ExactWeight {
        double w = 0.0;
        Vec3 gradient{0.0};
    };
    void exact_weights(const Vec3& x, std::size_t first, std::span<ExactWeight> out) const;

    // Upper bounds over all of space: of the distance by which the field moves any point, and of
    // how many times longer it makes any short edge. They follow from the convex hull of Bernstein
    // coefficients on each axis, and so are not tight. displacements: weight_count. Cost:
    // O(weights).
    double reach_bound(std::span<const Vec3> displacements) const;
    double lipschitz_bound(std::span<const Vec3> displacements) const;
    // An upper bound of |∇w| over all of space, for one weight. O(1).
    double gradient_bound(std::size_t weight) const { return bounds_[weight].gradient; }

    // ΔP = Bᵀ(BBᵀ)⁻¹ d, in the order of Lattice::control_index. displacements: weight_count.
    std::vector<Vec3> control_displacements(std::span<const Vec3> displacements) const;

  private:
    // f(u) = Σ_i coefficient_i β(u − i). It is a cubic in each of the 7 cells that its 4 terms
    // reach, stored in powers of the position inside the cell.
    struct AxisCubics {
        int first_cell = 0;
        std::array<std::array<double, 4>, 7> power{};
    };
    // The scalar product of a constraint's row with b(x) is a product of three such functions.
    using Product = std::array<AxisCubics, 3>;
    struct Location {
        IVec3 cell;
        Vec3 inside;
    };
    struct Value {
        double value = 0.0;
        Vec3 derivative{0.0};  // per cell
    };

    // Upper bounds of |w| and |∇w|.
    struct Bound {
        double weight = 0.0, gradient = 0.0;
    };
    static Bound bound_of(const AxisCubics& cubics);
    void bound_weights();

    static AxisCubics axis_cubics(const BasisRow& row, std::size_t axis);
    static Value evaluate(const Product& product, const Location& at);
    Location locate(const Vec3& x) const;
    DragWeight rounded(const Value& sum) const;
    void weights_inside(const Location& at, std::span<DragWeight> out) const;
    void spline_weights(const Vec3& x, std::span<DragWeight> out) const;
    std::vector<Vec3> spline_displacements(std::span<const Vec3> displacements) const;
    template <std::size_t batch>
    void weights_in_batches(const Location& at, std::span<DragWeight> out) const;

    Lattice lattice_;
    Box zone_;
    Vec3 inverse_cell_;
    std::size_t weight_count_ = 0;
    std::vector<BasisRow> constraints_;
    std::vector<Product> products_;      // one for each constraint
    std::vector<double> inverse_;        // weight_count × constraints
    std::vector<Bound> bounds_;          // weight_count
    std::vector<WeightSpline> splines_;  // weight_count, instead of the constraints; or empty
};

}  // namespace pectin

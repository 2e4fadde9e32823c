// The deformation of a gesture, as a function linear in its drags: D(x) = Σ_c w_c(x) d_c.
// Source: Hsu, Hughes & Kaufman 1992 (direct manipulation), rearranged; Gain & Dodgson 1999,
// equations 1–7.
//
// With b(x) the basis values of all control points at x and B the rows of the constraints,
// D(x) = b(x)ᵀ Bᵀ(BBᵀ)⁻¹ d, so w(x) = (BBᵀ)⁻¹ B b(x) depends on the rest position alone. A gesture
// evaluates w and ∇w once per vertex; a frame is the kernels at the end of this file.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "ffd/basis_row.h"
#include "ffd/cofactor.h"
#include "ffd/lattice.h"

namespace pectin {

// The share of one drag in the displacement of one point.
struct DragWeight {
    float w = 0.0f;
    Vec3f gradient{0.0f};  // ∂w/∂x, per world unit
};
static_assert(sizeof(DragWeight) == 16);

class DragField {
  public:
    // constraints: the rows of the constrained points. inverse: (BBᵀ)⁻¹ of the moves against all
    // constraints, move-major, move_count × constraints, such that w_c(x) = Σ_a inverse[c][a] ·
    // (row a · b(x)) with rows of unit length. A DragSolver makes them.
    DragField(const Lattice& lattice, std::vector<BasisRow> constraints,
              std::vector<double> inverse);

    const Lattice& lattice() const { return lattice_; }
    std::size_t move_count() const { return move_count_; }

    // out: move_count. Exactly zero on the border of the influenced zone and outside. Evaluated in
    // double, rounded once. About 40 multiplications a constraint near x, and four for each of
    // these and each move.
    void weights(const Vec3& x, std::span<DragWeight> out) const;

    // out: n_points × move_count, point-major; each point as by the function above, to the bit.
    void weights(std::span<const Vec3> points, std::span<DragWeight> out) const;

    // The same before it is rounded, of the moves from `first` on: for sums that cancel.
    struct ExactWeight {
        double w = 0.0;
        Vec3 gradient{0.0};
    };
    void exact_weights(const Vec3& x, std::size_t first, std::span<ExactWeight> out) const;

    // Bounds over all of space, by the convex hull of Bernstein coefficients, per axis and so not
    // tight: how far the drags move anything, and how many times as long they make anything.
    // displacements: move_count. Cost: O(moves).
    double reach_bound(std::span<const Vec3> displacements) const;
    double lipschitz_bound(std::span<const Vec3> displacements) const;
    // The same of one move: |∇w| is nowhere greater. O(1).
    double gradient_bound(std::size_t move) const { return bounds_[move].gradient; }

    // ΔP = Bᵀ(BBᵀ)⁻¹ d, in the order of Lattice::control_index. displacements: move_count.
    std::vector<Vec3> control_displacements(std::span<const Vec3> displacements) const;

  private:
    // f(u) = Σ_i coefficient_i β(u − i): a cubic in each of the 7 cells that reach its 4 terms,
    // in powers of the position inside the cell.
    struct AxisCubics {
        int first_cell = 0;
        std::array<std::array<double, 4>, 7> power{};
    };
    // The scalar product of a constraint's row with b(x), a product of three such functions.
    using Product = std::array<AxisCubics, 3>;
    struct Location {
        IVec3 cell;
        Vec3 inside;
    };
    struct Value {
        double value = 0.0;
        Vec3 derivative{0.0};  // per cell
    };

    // Of one move: |w| and |∇w| are nowhere greater.
    struct Bound {
        double weight = 0.0, gradient = 0.0;
    };
    static Bound bound_of(const AxisCubics& cubics);
    void bound_moves();

    static AxisCubics axis_cubics(const BasisRow& row, std::size_t axis);
    static Value evaluate(const Product& product, const Location& at);
    Location locate(const Vec3& x) const;
    DragWeight rounded(const Value& sum) const;
    void weights_inside(const Location& at, std::span<DragWeight> out) const;
    template <std::size_t batch>
    void weights_in_batches(const Location& at, std::span<DragWeight> out) const;

    Lattice lattice_;
    Box zone_;
    Vec3 inverse_cell_;
    std::size_t move_count_ = 0;
    std::vector<BasisRow> constraints_;
    std::vector<Product> products_;  // one per constraint
    std::vector<double> inverse_;    // move_count × constraints
    std::vector<Bound> bounds_;      // move_count
};

// --- A frame: everything below is per vertex, without branches on the data where one drag acts ---

// The rest position, displaced. weights, d: move_count.
inline Vec3 displaced(const Vec3& rest, const DragWeight& weight, const Vec3& d) {
    return rest + static_cast<double>(weight.w) * d;
}
inline Vec3 displaced(const Vec3& rest, std::span<const DragWeight> weights,
                      std::span<const Vec3> d) {
    if (weights.size() == 1) return displaced(rest, weights[0], d[0]);
    Vec3 sum{0.0};
    for (std::size_t c = 0; c < weights.size(); ++c) {
        sum += static_cast<double>(weights[c].w) * d[c];
    }
    return rest + sum;
}

// J = I + Σ d_c ∇w_cᵀ, in world units.
inline Mat3 jacobian(std::span<const DragWeight> weights, std::span<const Vec3> d) {
    Mat3 sum{1.0};
    for (std::size_t c = 0; c < weights.size(); ++c) {
        sum += glm::outerProduct(d[c], Vec3{weights[c].gradient});
    }
    return sum;
}

// det J; not positive where space folds. For one drag det(I + d ∇wᵀ) = 1 + ∇w·d.
inline double jacobian_determinant(const DragWeight& weight, const Vec3& d) {
    return 1.0 + glm::dot(Vec3{weight.gradient}, d);
}
inline double jacobian_determinant(std::span<const DragWeight> weights, std::span<const Vec3> d) {
    if (weights.size() == 1) return jacobian_determinant(weights[0], d[0]);
    return glm::determinant(jacobian(weights, d));
}

// Whether a drag changes directions at a point at all.
inline bool bends(const DragWeight& weight, const Vec3& d) {
    return weight.gradient != Vec3f{0.0f} && d != Vec3{0.0};
}

// Bounds of |image|² within which the image of a unit normal, computed in float, is good to some
// units in the last place: it is neither out of range nor what is left of larger terms that cancel.
inline constexpr float kLeastSquare = 0.0625f, kGreatestSquare = 1e30f;

// normalise(cof(J)·n); for one drag cof(I + d ∇wᵀ)·n = (1 + ∇w·d) n − (d·n) ∇w, no matrix at all.
// Where no drag bends anything n comes back as it is, to the bit. A zero n, or one whose image has
// no direction, gives zero. For one drag in float where that is exact enough (the terms are of the
// size of the greater of 1 and |1 + ∇w·d|), else in double.
inline Vec3f covariant_normal(const Vec3f& n, const DragWeight& weight, const Vec3& d) {
    if (!bends(weight, d)) return n;
    const Vec3f& g = weight.gradient;
    const Vec3f e{d};
    const float stretch = 1.0f + glm::dot(g, e);
    const Vec3f image = stretch * n - glm::dot(e, n) * g;
    const float squared = glm::dot(image, image);
    if (squared >= kLeastSquare && squared <= kGreatestSquare &&
        squared >= kLeastSquare * (stretch * stretch)) {
        return (1.0f / std::sqrt(squared)) * image;
    }
    const Vec3 normal{n}, gradient{g};
    return Vec3f{
        unit_or_zero((1.0 + glm::dot(gradient, d)) * normal - glm::dot(d, normal) * gradient)};
}
inline Vec3f covariant_normal(const Vec3f& n, std::span<const DragWeight> weights,
                              std::span<const Vec3> d) {
    if (weights.size() == 1) return covariant_normal(n, weights[0], d[0]);
    bool any = false;
    for (std::size_t c = 0; c < weights.size() && !any; ++c) any = bends(weights[c], d[c]);
    return any ? Vec3f{unit_or_zero(cofactor_times(jacobian(weights, d), Vec3{n}))} : n;
}

}  // namespace pectin

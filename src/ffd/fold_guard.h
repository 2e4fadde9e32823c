// The injectivity proof for the steps of one solver, with the repetition of proofs avoided.
// Source: J. Gain, N. Dodgson. Preventing Self-Intersection under Free-Form Deformation. IEEE
// Transactions on Visualization and Computer Graphics 7(4), 2001.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ffd/drag_solver.h"
#include "ffd/drag_step.h"

namespace pectin {

// Returns the largest t in (0, 1] for which t times the step is proven one to one; 0 if nothing is
// proven. Cost: that of injective_limit().
double proven_fraction(const DragStep& step);

// proven_fraction() for many steps of one solver, with which a hand moves only a little from one
// step to the next.
//
// With the solver fixed, D is linear in its displacements d. Let h(d) be the least h for which the
// proof gives t = (1 − kLeastStretch)/h. As a maximum of linear functions (of d·g_i, or of −vᵀS_i v
// over i and unit v) h is convex, and h(td) = t h(d). So for any d₀ and t ≥ 0
//     h(d) ≤ t h(d₀) + h(d − t d₀) ≤ t h(d₀) + Σ_c G_c |d_c − t d₀_c|,    G_c ≥ |∇w_c| everywhere.
// This often makes a proof unnecessary: near d = 0, and near and along each of the last few d₀ for
// which a proof was made.
class FoldGuard {
  public:
    explicit FoldGuard(const DragSolver& solver);

    // Returns what proven_fraction() returns, bit for bit. Precondition: a step of the solver.
    // Cost: that of the proof if one is needed. The first call also computes one bound for each
    // weight: over all control points, or in O(weights) and less tight if there are many weights.
    double limit(const DragStep& step);

  private:
    struct Proof {
        std::vector<Vec3> displacements;  // d₀
        double steepness = 0.0;           // h(d₀)
    };
    // The upper bound of h(d) that one proof gives.
    double steepness_by(const Proof& proof, std::span<const Vec3> displacements) const;
    void bound_weights(const DragStep& step);

    std::vector<double> bounds_;  // G_c for each weight of the field, computed when first needed
    std::vector<Proof> proofs_;   // the first is d₀ = 0, the others are the most recent ones
    std::size_t next_ = 1;        // the proof that the next one replaces
};

}  // namespace pectin

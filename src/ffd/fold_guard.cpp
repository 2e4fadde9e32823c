#include "ffd/fold_guard.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "ffd/injectivity.h"

namespace pectin {
namespace {

// How much farther than the step the proof looks, so that it answers the next questions, too.
constexpr double kProofMargin = 1.5;
// The number of proofs that a guard keeps. A hand that wavers returns to directions that it had
// some frames ago.
constexpr std::size_t kProofsKept = 8;
// The number of weights up to which a guard computes tight bounds. Each of them takes a pass over
// the whole lattice.
constexpr std::size_t kMostTightBounds = 32;
// The relative rounding error of a bound, so that it never allows what the proof would not.
constexpr double kRounding = 1e-9;

// A unit displacement of one weight. With symmetry it lies in the direction that its parity allows.
Vec3 unit_displacement(const DragStep& step, std::size_t weight) {
    Vec3 unit{0.0};
    const int across = step.symmetry ? step.symmetry->plane.axis : 0;
    const bool is_odd = step.symmetry && step.symmetry->parity[weight] < 0.0;
    unit[is_odd || !step.symmetry ? across : (across + 1) % 3] = 1.0;
    return unit;
}

}  // namespace

double proven_fraction(const DragStep& step) {
    return std::min(1.0, injective_limit(step, kProofMargin));
}

FoldGuard::FoldGuard(const DragSolver& solver) {
    proofs_.push_back({std::vector<Vec3>(solver.field().weight_count(), Vec3{0.0})});
}

void FoldGuard::bound_weights(const DragStep& step) {
    DragStep unit = step;
    bounds_.assign(step.displacements.size(), 0.0);
    const bool is_tight = bounds_.size() <= kMostTightBounds;
    for (std::size_t c = 0; c < bounds_.size(); ++c) {
        if (!is_tight) {  // the bounds of both sides add up
            bounds_[c] = (step.symmetry ? 2.0 : 1.0) * step.field.gradient_bound(c);
            continue;
        }
        std::fill(unit.displacements.begin(), unit.displacements.end(), Vec3{0.0});
        unit.displacements[c] = unit_displacement(step, c);
        bounds_[c] = gradient_bound(unit.lattice_fields());
    }
}

double FoldGuard::steepness_by(const Proof& proof, std::span<const Vec3> displacements) const {
    double along = 0.0, squared = 0.0;
    for (std::size_t c = 0; c < bounds_.size(); ++c) {
        along += glm::dot(displacements[c], proof.displacements[c]);
        squared += glm::dot(proof.displacements[c], proof.displacements[c]);
    }
    const double t = squared > 0.0 ? std::max(0.0, along / squared) : 0.0;
    double steepness = t * proof.steepness;
    for (std::size_t c = 0; c < bounds_.size(); ++c) {
        steepness += bounds_[c] * glm::length(displacements[c] - t * proof.displacements[c]);
    }
    return steepness;
}

double FoldGuard::limit(const DragStep& step) {
    if (bounds_.empty()) bound_weights(step);
    assert(bounds_.size() == step.displacements.size());
    for (const Proof& proof : proofs_) {
        const double steepness = steepness_by(proof, step.displacements);
        if (steepness <= (1.0 - kLeastStretch) * (1.0 - kRounding)) return 1.0;
    }
    const double found = injective_limit(step, kProofMargin);
    if (next_ == proofs_.size()) proofs_.emplace_back();
    proofs_[next_].displacements = step.displacements;  // keeps its memory
    proofs_[next_].steepness = (1.0 - kLeastStretch) / found;
    next_ = next_ == kProofsKept ? 1 : next_ + 1;
    return std::min(1.0, found);
}

}  // namespace pectin

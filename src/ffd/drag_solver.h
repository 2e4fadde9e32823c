// Direct manipulation: the smallest displacement of the lattice that takes handles to their targets
// and holds pins.
// Source: W. M. Hsu, J. F. Hughes, H. Kaufman. Direct Manipulation of Free-Form Deformations.
// SIGGRAPH 1992: section 3.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "ffd/constraint.h"
#include "ffd/deformation.h"
#include "ffd/drag_field.h"
#include "ffd/drag_refusal.h"
#include "ffd/handle.h"
#include "ffd/lattice.h"
#include "ffd/symmetry.h"
#include "geometry/falloff.h"

namespace pectin {

// The largest number of distinct constraints of the handles and pins of one drag. The dense system
// is too slow for interaction beyond it.
inline constexpr std::size_t kMaxConstraints = 1024;

// Near the border of the influenced zone the basis decreases to zero with the third power, and a
// drag there displaces control points far. A control point that moves more than this many times as
// far as the handle would tear the rest of the zone.
inline constexpr double kMaxControlGain = 1000.0;
// The same limit where folds are prevented. A hand that moves on along the border shears the zone
// again in every step, and refinement does not end (measured in 16 drags along the border of a
// cage: up to 1,300,000 faces, and with this limit up to 32,000).
inline constexpr double kMaxFoldFreeGain = 100.0;

// The least squared sine of the angle between the row of a constraint and the span of the others.
// At 1e-8 two points are about 1e-4 cells apart. To move them differently shears the lattice by 1e4
// times the drag, and the relative error of the solution is 1e-16 / 1e-8, which is still less than
// float weights resolve.
inline constexpr double kMinIndependence = 1e-8;

class DragSolver {
  public:
    // Factorises the system once for a gesture. Everything is in world space and in the rest state.
    // handles: at least one, all strictly inside the influenced zone, or with a plane inside the
    // mirror image of the zone. pins: points to hold; pins outside the zone have no effect. Equal
    // points count once. With a plane all constraints are met on both sides. max_gain: the largest
    // displacement of a control point, in multiples of the displacement of a handle. falloff: with
    // a plateau all constraints are met as exactly, by other displacements (ffd/plateau.h).
    // Cost: O(n³) for n distinct constraints, and O(1) for each handle or pin that repeats another.
    // A plateau takes O(control points) more for each pair of constraints.
    static std::variant<DragSolver, DragRefusal> create(
        const Lattice& lattice, std::span<const Handle> handles, std::span<const Vec3> pins,
        const std::optional<MirrorPlane>& plane = std::nullopt, double max_gain = kMaxControlGain,
        Falloff falloff = Falloff::sharp);
    // The same for handles that prescribe no Jacobian.
    static std::variant<DragSolver, DragRefusal> create(const Lattice& lattice,
                                                        std::span<const Vec3> points,
                                                        std::span<const Vec3> pins);

    // The field has one weight for each driven constraint, whose value a handle prescribes (those
    // of pins stay zero): the displacement of each handle, and for a handle that prescribes its
    // Jacobian also ∂D/∂x, ∂D/∂y and ∂D/∂z. With a plane each of these is divided into components
    // within and across the plane. Handles at the same point share their weights.
    const DragField& field() const { return field_; }
    const std::optional<Symmetry>& symmetry() const { return symmetry_; }

    // motions: one for each handle. Refused are motions that are not finite, different motions of
    // the same point, motions of a pinned point, and motions on the plane that are not symmetric.
    std::optional<DragRefusal> check(std::span<const HandleMotion> motions) const;
    std::optional<DragRefusal> check(std::span<const Vec3> displacements) const;

    // --- Precondition of these: the motions pass check().

    // The displacements d of the field's weights: field().weight_count().
    std::vector<Vec3> field_displacements(std::span<const HandleMotion> motions) const;
    // The same for a step of this solver, which gets these displacements. Allocates nothing.
    void set_motions(std::span<const HandleMotion> motions, DragStep& step) const;
    DragStep step(std::span<const HandleMotion> motions) const {
        return {field_, field_displacements(motions), symmetry_};
    }
    // The step in the form that is the fastest to evaluate; see compact().
    Deformation deformation(std::span<const HandleMotion> motions) const {
        return compact(step(motions));
    }
    // The displacements of deformation(motions).
    std::vector<Vec3> displacements(std::span<const HandleMotion> motions) const;

    // Without a plateau ΔP = Bᵀ(BBᵀ)⁻¹ d: of all displacements of the control points that meet all
    // constraints exactly, the one with the smallest sum of squares (the minimum-norm solution):
    // control_count of the lattice, in the order of control_index. displacements: one for each
    // handle.
    std::vector<Vec3> control_displacements(std::span<const Vec3> displacements) const;

  private:
    // A handle on the plane's positive side, and its relation to the plane and to other handles.
    struct CanonicalHandle {
        Vec3 given;  // the point as it was given
        Vec3 point;  // that point, or its image on the plane's positive side
        bool prescribes_jacobian = false, is_flipped = false;
        bool is_pinned = false;  // set for the first handle at the point
        bool is_on_plane = false, is_near_plane = false;
        std::size_t first_at_point = 0;  // the first handle at the point, often this one
        std::size_t first_jacobian = 0;  // the first one there that prescribes a Jacobian, if any
    };
    // A driven constraint and the handle that prescribes its value.
    struct DrivenConstraint {
        std::size_t handle;
        ConstraintKey key;
    };
    class Builder;

    DragSolver(DragField field, std::optional<Symmetry> symmetry,
               std::vector<CanonicalHandle> handles, std::vector<DrivenConstraint> driven);
    // The value that a handle prescribes for the constraint.
    Vec3 prescribed(const DrivenConstraint& driven, std::span<const HandleMotion> motions) const;
    HandleMotion on_positive_side(const CanonicalHandle& handle, const HandleMotion& motion) const;
    std::optional<DragRefusal> check_agreement(std::size_t handle,
                                               std::span<const HandleMotion> motions) const;
    std::optional<DragRefusal> check_symmetry(const CanonicalHandle& handle,
                                              const HandleMotion& motion) const;

    DragField field_;
    std::optional<Symmetry> symmetry_;
    std::vector<CanonicalHandle> handles_;
    std::vector<DrivenConstraint> driven_;
};

}  // namespace pectin

// Direct manipulation: the smallest displacement of the lattice that takes points where they are
// dragged and holds others.
// Source: Hsu, Hughes & Kaufman, Direct Manipulation of Free-Form Deformations, 1992, section 3.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "ffd/constraint.h"
#include "ffd/drag_field.h"
#include "ffd/lattice.h"
#include "ffd/symmetry.h"
#include "ffd/warp.h"

namespace pectin {

// Why a drag cannot be met: what is wrong and what would be right, for the user.
struct DragRefusal {
    std::string what;
};

// Distinct rows of moves and pins in one drag; beyond it the dense system no longer suits
// interaction.
inline constexpr std::size_t kMaxConstraints = 1024;

// Near the border of the influenced zone the basis falls to zero by the third power, and meeting a
// drag throws the control points far. Past this many times the drag the rest of the zone is torn.
inline constexpr double kMaxControlGain = 1000.0;
// The same where folds are prevented: a hand that goes on along the border shears the zone anew in
// every step, and its refinement has no end (measured in 16 drags along a cage's border: up to
// 1,300,000 faces, within this limit up to 32,000).
inline constexpr double kMaxFoldFreeGain = 100.0;

// The least squared sine of the angle between a constraint's row and the span of the others'. At
// 1e-8 two points are about 1e-4 cells apart: asking them to differ shears the lattice 1e4 times
// the drag, and the solution is off by 1e-16 / 1e-8 of it, still below what float weights resolve.
inline constexpr double kMinIndependence = 1e-8;

// A point to be moved.
struct Handle {
    Vec3 point{0.0};
    bool prescribes_jacobian = false;  // its Jacobian is prescribed, too
};
// What is asked of it.
struct HandleMotion {
    Vec3 displacement{0.0};
    Mat3 jacobian{1.0};  // of the deformation at the point; not looked at unless it turns
};

class DragSolver {
  public:
    // Factorises once a gesture. grips: at least one, all strictly inside the influenced zone (or,
    // with a plane, inside its image). pins: points to hold; pins outside are held anyway. Points
    // at the same place count once. Everything in world space, at rest. With a plane all of it is
    // met on both sides. max_gain: how far a control point may be thrown for a grip, in times its
    // move. O(n³) in the distinct rows, O(n) in grips and pins that repeat others.
    static std::variant<DragSolver, DragRefusal> create(
        const Lattice& lattice, std::span<const Handle> handles, std::span<const Vec3> pins,
        const std::optional<MirrorPlane>& plane = std::nullopt, double max_gain = kMaxControlGain);
    // The same for points that do not turn.
    static std::variant<DragSolver, DragRefusal> create(const Lattice& lattice,
                                                        std::span<const Vec3> move_points,
                                                        std::span<const Vec3> pins);

    // The rows that are driven, as the moves of a field: of every grip its displacement, where it
    // turns then ∂D/∂x, ∂D/∂y, ∂D/∂z; with a plane each as its parts within and across the plane.
    // Several that ask for the same at one point are one move of the field.
    const DragField& field() const { return field_; }
    const std::optional<Symmetry>& symmetry() const { return symmetry_; }

    // motions: one a grip. Refused where they are not finite, where two of one place differ, where
    // a pinned point is asked to move, and where they are not symmetric on the plane.
    std::optional<DragRefusal> check(std::span<const HandleMotion> motions) const;
    std::optional<DragRefusal> check(std::span<const Vec3> displacements) const;

    // What the motions ask of the field's moves: field().move_count(). Precondition: they pass
    // check().
    std::vector<Vec3> field_displacements(std::span<const HandleMotion> motions) const;
    DragStep step(std::span<const HandleMotion> motions) const {
        return {field_, field_displacements(motions), symmetry_};
    }

    // ΔP = Bᵀ(BBᵀ)⁻¹ d, the least-squares smallest that meets the drags exactly: control_count of
    // the lattice, in the order of control_index. displacements: one a grip, passing check().
    std::vector<Vec3> control_displacements(std::span<const Vec3> displacements) const;

  private:
    struct Move {
        Vec3 asked;  // the point as given
        Vec3 point;  // the same, or its image on the plane's positive side
        bool prescribes_jacobian = false, is_flipped = false;
        bool is_pinned = false;  // of the first move there
        bool is_on_plane = false, is_near_plane = false;
        std::size_t first_at_point = 0;  // the first move there, often itself
        std::size_t first_jacobian = 0;  // the first there that prescribes it, where this one does
    };
    struct Column {
        std::size_t move;
        ConstraintKey key;
    };
    class Builder;

    DragSolver(DragField field, std::optional<Symmetry> symmetry, std::vector<Move> moves,
               std::vector<Column> columns);
    HandleMotion on_positive_side(const Move& move, const HandleMotion& motion) const;
    std::optional<DragRefusal> check_symmetry(const Move& move, const HandleMotion& motion) const;

    DragField field_;
    std::optional<Symmetry> symmetry_;
    std::vector<Move> moves_;
    std::vector<Column> columns_;
};

}  // namespace pectin

// Direct manipulation: the smallest displacement of the lattice that takes points where they are
// dragged and holds others.
// Source: Hsu, Hughes & Kaufman, Direct Manipulation of Free-Form Deformations, 1992, section 3.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "ffd/drag_field.h"
#include "ffd/lattice.h"

namespace pectin {

// Why a drag cannot be met: what is wrong and what would be right, for the user.
struct DragRefusal {
    std::string what;
};

// Distinct points in one drag; beyond it the dense system no longer suits interaction.
inline constexpr std::size_t kMaxConstraints = 1024;

// Near the border of the influenced zone the basis falls to zero by the third power, and meeting a
// drag throws the control points far. Past this many times the drag the rest of the zone is torn.
inline constexpr double kMaxControlGain = 1000.0;

// The least squared sine of the angle between a constraint's row and the span of the others'. At
// 1e-8 two points are about 1e-4 cells apart: asking them to differ shears the lattice 1e4 times
// the drag, and the solution is off by 1e-16 / 1e-8 of it, still below what float weights resolve.
inline constexpr double kMinIndependence = 1e-8;

class DragSolver {
  public:
    // Factorises once a gesture. move_points: those to drag, at least one, all strictly inside the
    // influenced zone. pins: those to hold; pins outside the zone are held anyway. Points at the
    // same place count once. Everything in world space, at rest. O(n³) in the distinct points.
    static std::variant<DragSolver, DragRefusal> create(const Lattice& lattice,
                                                        std::span<const Vec3> move_points,
                                                        std::span<const Vec3> pins);

    // Weights of the moves. Of several at one place the first has the weight, the others zero.
    const DragField& field() const { return field_; }

    // displacements: move_count. Refused where they are not finite, where two moves of one place
    // differ and where a pinned point is asked to move.
    std::optional<DragRefusal> check(std::span<const Vec3> displacements) const;

    // ΔP = Bᵀ(BBᵀ)⁻¹ d, the least-squares smallest that meets the drags exactly: control_count of
    // the lattice, in the order of control_index. displacements: move_count, passing check().
    std::vector<Vec3> control_displacements(std::span<const Vec3> displacements) const;

  private:
    struct Move {
        Vec3 point;
        std::size_t same_place;  // the first move there, often itself
        bool pinned;
    };

    DragSolver(DragField field, std::vector<Move> moves);

    DragField field_;
    std::vector<Move> moves_;
};

}  // namespace pectin

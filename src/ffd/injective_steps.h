// A drag as a warp: plain, along waypoints, or in small steps each of which is proven one to one.
// Source: Gain & Dodgson, Preventing Self-Intersection under Free-Form Deformation, IEEE TVCG 7(4),
// 2001: small injective deformations, composed, with the object embedded anew between them.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "ffd/drag_solver.h"
#include "ffd/warp.h"

namespace pectin {

// Of a turn; beyond them it is a slip of the hand or of a script.
inline constexpr double kMostDegrees = 3600.0;
inline constexpr double kMostGrowth = 1000.0;  // or its inverse

// A turn about `axis` (any length above 0) by `degrees`, and a growth by `scale`.
struct Rotation {
    Vec3 axis{0.0, 0.0, 1.0};
    double degrees = 0.0;
    double scale = 1.0;

    bool is_none() const { return degrees == 0.0 && scale == 1.0; }
    // In how many steps at least this share of it is taken without folding: none turns by more than
    // 80 degrees. At 90 the Jacobian's symmetric part is definite no longer, and a Jacobian does
    // not tell a full turn from none.
    std::size_t least_steps(double fraction = 1.0) const;
    // Its Jacobian, or that of a share of it: those of shares that add up to 1 multiply to that
    // of 1.
    Mat3 jacobian(double fraction = 1.0) const;
    bool operator==(const Rotation&) const = default;
};

struct DragPlan {
    struct Move {
        Vec3 from{0.0}, to{0.0};
        Rotation rotation{};  // about the point
    };
    // The first move goes along `via`, in straight segments; each waypoint is a step's end. All
    // else (other moves, turns) waits for the last segment and is spread evenly over it. With
    // fold_free a turn goes all the way round; else only where it ends counts.
    std::vector<Move> moves;
    std::vector<Vec3> pins{}, via{};
    bool fold_free = false;              // else each segment is one step, whatever it folds
    std::optional<MirrorPlane> plane{};  // everything happens on both sides of it
    Lattice lattice{};                   // of the first step
    bool is_centred_on_point = false;    // a brush: every step's is centred on the first move
};

struct PlannedDrag {
    Warp warp;                 // at least one step
    std::vector<Vec3> points;  // where the first move's point is before each step
    DragSolver last;           // of the last step
    std::size_t last_segment;  // the step that begins it
};

// Steps of one drag: beyond it the target lies, as good as, where no fold-free drag leads.
inline constexpr std::size_t kMaxSteps = 256;

// Each step is as long as the proof allows, or so that all that remain are equally long. The point
// ends at its target as exactly as a single solve takes it there. Refused: what a DragSolver
// refuses anywhere on the way; turns beyond the limits above; a move or waypoint across the plane;
// more than kMaxSteps; with fold_free what no one to one deformation reaches: a target on the plane
// of a point beside it, or, with a fixed lattice, outside its zone.
// Cost: a solve and two or three proofs a step.
std::variant<PlannedDrag, DragRefusal> plan_drag(const DragPlan& plan);

// What plan_drag() refuses of targets and turns alone, without solving.
std::optional<DragRefusal> check_drag(const DragPlan& plan);

// injective_limit() of one solver's steps, for a hand that moves little between two questions.
//
// With the solver fixed, D is linear in its displacements d. Let h(d) be the least h for which the
// proof gives t = (1 − kLeastStretch)/h. As a largest value of linear functions (of d·g_i, or of
// −vᵀS_i v over i and unit v) h is convex and h(td) = t h(d), so for any d₀ and t ≥ 0
//     h(d) ≤ t h(d₀) + h(d − t d₀) ≤ t h(d₀) + Σ_c G_c |d_c − t d₀_c|,    G_c ≥ |∇w_c| everywhere.
// That often spares the proof: near d = 0, and near and along what was proven for the last few d₀,
// of which each gives a bound.
class FoldGuard {
  public:
    explicit FoldGuard(const DragSolver& solver);

    // The largest t in (0, 1] as injective_limit() finds it, or 0. Precondition: a step of the
    // solver. Cost: that of the proof where it is not spared. The first time also one bound for
    // each move, over all control points; with many moves only O(moves), by looser bounds.
    double limit(const DragStep& step);

  private:
    struct Proof {
        std::vector<Vec3> displacements;  // d₀
        double steepness = 0.0;           // h(d₀)
    };
    // The bound of h(d) by one proof.
    double steepness_by(const Proof& proof, std::span<const Vec3> displacements) const;
    void bound_moves(const DragStep& step);

    std::vector<double> bounds_;  // G_c, of every move of the field; found when first needed
    std::vector<Proof> proofs_;   // the first is d₀ = 0, the others the last few
    std::size_t next_ = 1;        // the oldest of these
};

}  // namespace pectin

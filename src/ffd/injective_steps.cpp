#include "ffd/injective_steps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string>

#include "ffd/injectivity.h"
#include "geometry/decimal.h"

namespace pectin {
namespace {

DragRefusal refuse_outside(const Vec3& target, const Box& zone) {
    return {"without folding nothing leaves the influenced zone " + decimal(zone.min) + " to " +
            decimal(zone.max) + ", and the target " + decimal(target) +
            " is not inside; take a target inside, a larger cage, or fold_free false"};
}

DragRefusal refuse_steps(const Vec3& target) {
    return {"the target " + decimal(target) + " cannot be reached in " + std::to_string(kMaxSteps) +
            " steps without folding; move less far, or in several drags, stay away from pins, "
            "other moved points, the symmetry plane and the border of the zone, or take a larger "
            "radius"};
}

DragRefusal refuse_waypoints() {
    return {"a drag takes at most " + std::to_string(kMaxSteps) +
            " steps, and each waypoint ends one; take fewer waypoints, or several drags"};
}

DragRefusal refuse_across(const MirrorPlane& plane, const Vec3& from, const Vec3& to) {
    return {"the drag from " + decimal(from) + " to " + decimal(to) +
            " goes across the symmetry plane, where it would meet its own image; keep it on its "
            "side of " +
            decimal(plane.onto(to)) + ", or switch symmetry off"};
}

DragRefusal refuse_onto(const Vec3& to) {
    return {"the target " + decimal(to) +
            " is on the symmetry plane, where without folding no point beside it arrives, as it "
            "would meet its own image; take a target beside the plane, or drag a point on it"};
}

DragRefusal refuse_rotation(const Rotation& rotation) {
    return {"a turn needs an axis with a length, at most " + decimal(kMostDegrees) +
            " degrees either way and a scale from " + decimal(1.0 / kMostGrowth) + " to " +
            decimal(kMostGrowth) + "; axis " + decimal(rotation.axis) + ", " +
            decimal(rotation.degrees) + " degrees, scale " + decimal(rotation.scale) + " is none"};
}

// The axis may be as long or short as numbers are.
Vec3 unit_axis(const Rotation& rotation) {
    const Vec3 size = glm::abs(rotation.axis);
    const double largest = std::max({size.x, size.y, size.z});
    if (!(largest > 0.0) || !is_finite(rotation.axis)) return Vec3{0.0};
    return glm::normalize(rotation.axis / largest);
}

bool is_usable(const Rotation& rotation) {
    return unit_axis(rotation) != Vec3{0.0} && std::abs(rotation.degrees) <= kMostDegrees &&
           rotation.scale >= 1.0 / kMostGrowth && rotation.scale <= kMostGrowth;
}

bool is_on_plane(const DragPlan& plan, const Vec3& point) {
    return std::abs(plan.plane->offset(point)) <=
           kOnPlaneFraction * plan.lattice.cell[plan.plane->axis];
}

std::optional<DragRefusal> check_target(const DragPlan& plan, const Vec3& from, const Vec3& to) {
    const auto& plane = plan.plane;
    if (plane && plane->offset(from) * plane->offset(to) < 0.0 && !is_on_plane(plan, from)) {
        return refuse_across(*plane, from, to);
    }
    if (plane && plan.fold_free && is_on_plane(plan, to) && !is_on_plane(plan, from)) {
        return refuse_onto(to);
    }
    if (!plan.fold_free || plan.is_centred_on_point || plan.lattice.influences(to) ||
        (plane && plan.lattice.influences(plane->image(to)))) {
        return std::nullopt;
    }
    return refuse_outside(to, plan.lattice.influenced_zone());
}

// How far beyond a step the proof looks, so that the next questions are answered.
constexpr double kProofMargin = 1.5;
// Proofs that a guard keeps: a hand that wavers comes back to directions it had some frames ago.
constexpr std::size_t kProofsKept = 8;
// Moves for which a guard finds tight bounds. Each takes a pass over the whole lattice.
constexpr std::size_t kMostTightBounds = 32;
// What a bound may be off by, so that it never grants what the proof itself would not.
constexpr double kRounding = 1e-9;
// Of a turn, in a step.
constexpr double kDegreesAStep = 80.0;

// The largest t in (0, 1] for which t times the step is proven; the guard and the planner have to
// agree on it to the bit.
double proven_fraction(const DragStep& step) {
    return std::min(1.0, injective_limit(step.lattice_fields(), kProofMargin));
}

class Planner {
  public:
    explicit Planner(const DragPlan& plan) : plan_(plan) {
        for (const DragPlan::Move& move : plan_.moves) {
            handles_.push_back({move.from});
        }
    }

    std::variant<PlannedDrag, DragRefusal> run() {
        if (handles_.empty()) return DragRefusal{"a drag needs at least one point to move"};
        if (const auto refusal = check_drag(plan_)) return *refusal;
        Vec3 at = plan_.moves.front().from;
        for (const Vec3& waypoint : plan_.via) {
            if (waypoint == at) continue;
            if (const auto refusal = segment(at, waypoint, false)) return *refusal;
            at = waypoint;
        }
        const std::size_t last_segment = warp_.steps.size();
        if (const auto refusal = segment(at, plan_.moves.front().to, true)) return *refusal;
        return PlannedDrag{std::move(warp_), std::move(points_), std::move(*solver_), last_segment};
    }

  private:
    // The first move goes from a to b; in the last segment everything else happens, too.
    std::optional<DragRefusal> segment(const Vec3& a, const Vec3& b, bool is_last) {
        double done = 0.0;
        std::size_t pieces = 1;  // of what remains
        while (true) {
            if (auto refusal = solve_at(a, b, done, is_last)) return refusal;
            const auto motions = [&](std::size_t of) {
                return motions_between(a, b, done, of == 1 ? 1.0 : done + (1.0 - done) / double(of),
                                       is_last);
            };
            if (auto refusal = solver_->check(motions(1))) return on_the_way(*refusal, b, is_last);
            if (warp_.steps.size() == kMaxSteps) return refuse_waypoints();
            if (plan_.fold_free) {
                const auto enough = enough_pieces(pieces, done, motions, is_last);
                if (!enough) return refuse_steps(target(b, is_last));
                pieces = *enough;
            }
            points_.push_back(handles_.front().point);
            warp_.steps.push_back(compact(solver_->step(motions(pieces))));
            if (pieces == 1) return std::nullopt;
            done += (1.0 - done) / static_cast<double>(pieces);
            --pieces;
        }
    }

    // In how many equal steps, from `pieces` up, the rest of the segment may go, as far as the next
    // of them tells; none if in no more than there may be.
    template <typename Motions>
    std::optional<std::size_t> enough_pieces(std::size_t pieces, double done,
                                             const Motions& motions, bool is_last) {
        const std::size_t most = kMaxSteps - warp_.steps.size();
        for (const DragPlan::Move& move : plan_.moves) {
            if (is_last) pieces = std::max(pieces, move.rotation.least_steps(1.0 - done));
        }
        while (pieces <= most) {
            const double t = proven_fraction(solver_->step(motions(pieces)));
            if (t >= 1.0) return pieces;
            const double enough = std::ceil(static_cast<double>(pieces) / t);
            if (!(enough <= static_cast<double>(most))) return std::nullopt;
            pieces = std::max(pieces + 1, static_cast<std::size_t>(enough));
        }
        return std::nullopt;
    }

    // Of the moves in the segment to b the target of the one that goes farthest.
    Vec3 target(const Vec3& b, bool is_last) const {
        Vec3 farthest = b;
        double distance = glm::distance(handles_.front().point, b);
        for (std::size_t m = 1; is_last && m < handles_.size(); ++m) {
            const double of_move = glm::distance(handles_[m].point, plan_.moves[m].to);
            if (!(of_move > distance)) continue;
            distance = of_move;
            farthest = plan_.moves[m].to;
        }
        return farthest;
    }

    // A refusal of a later step speaks of places that are in none of the moves.
    DragRefusal on_the_way(DragRefusal refusal, const Vec3& b, bool is_last) const {
        if (warp_.steps.empty()) return refusal;
        return {"on the way to " + decimal(target(b, is_last)) + ", " + refusal.what};
    }

    static Vec3 between(const Vec3& a, const Vec3& b, double fraction) {
        return fraction == 1.0 ? b : a + fraction * (b - a);
    }
    Vec3 point_of(std::size_t move, const Vec3& a, const Vec3& b, double fraction,
                  bool is_last) const {
        if (move == 0) return between(a, b, fraction);
        const auto& [from, to, rotation] = plan_.moves[move];
        return is_last ? between(from, to, fraction) : from;
    }

    std::optional<DragRefusal> solve_at(const Vec3& a, const Vec3& b, double done, bool is_last) {
        for (std::size_t m = 0; m < handles_.size(); ++m) {
            handles_[m] = {point_of(m, a, b, done, is_last),
                           is_last && !plan_.moves[m].rotation.is_none()};
        }
        Lattice lattice = plan_.lattice;
        if (plan_.is_centred_on_point && handles_.front().point != plan_.moves.front().from) {
            lattice.origin =
                handles_.front().point - 0.5 * Vec3{lattice.deformable - 1} * lattice.cell;
        }
        auto solved = DragSolver::create(lattice, handles_, plan_.pins, plan_.plane,
                                         plan_.fold_free ? kMaxFoldFreeGain : kMaxControlGain);
        if (auto* refusal = std::get_if<DragRefusal>(&solved)) {
            return on_the_way(std::move(*refusal), b, is_last);
        }
        solver_.emplace(std::move(std::get<DragSolver>(solved)));
        return std::nullopt;
    }

    std::vector<HandleMotion> motions_between(const Vec3& a, const Vec3& b, double done,
                                              double next, bool is_last) const {
        std::vector<HandleMotion> motions;
        for (std::size_t m = 0; m < handles_.size(); ++m) {
            const Vec3 to = point_of(m, a, b, next, is_last);
            const Rotation& rotation = plan_.moves[m].rotation;
            motions.push_back(
                {to - handles_[m].point, is_last ? rotation.jacobian(next - done) : Mat3{1.0}});
        }
        return motions;
    }

    const DragPlan& plan_;
    std::vector<Handle> handles_;  // where they are before the next step
    Warp warp_;
    std::vector<Vec3> points_;
    std::optional<DragSolver> solver_;
};

}  // namespace

// Rodrigues' formula.
Mat3 Rotation::jacobian(double fraction) const {
    if (is_none()) return Mat3{1.0};
    const Vec3 k = unit_axis(*this);
    const double angle = fraction * degrees * std::numbers::pi / 180.0;
    const Mat3 cross{0.0, k.z, -k.y, -k.z, 0.0, k.x, k.y, -k.x, 0.0};
    const Mat3 rotation =
        Mat3{1.0} + std::sin(angle) * cross + (1.0 - std::cos(angle)) * (cross * cross);
    return std::pow(scale, fraction) * rotation;
}

std::size_t Rotation::least_steps(double fraction) const {
    // A share of 1/n of it, n steps before the end, is not rounded up to a step more.
    const double steps = std::ceil(fraction * std::abs(degrees) / kDegreesAStep - kRounding);
    return std::max(std::size_t{1}, static_cast<std::size_t>(steps));
}

std::optional<DragRefusal> check_drag(const DragPlan& plan) {
    for (const DragPlan::Move& move : plan.moves) {
        if (!is_usable(move.rotation)) return refuse_rotation(move.rotation);
        if (const auto refusal = check_target(plan, move.from, move.to)) return refusal;
    }
    for (const Vec3& waypoint : plan.via) {
        if (!is_finite(waypoint)) {
            return DragRefusal{"waypoint " + decimal(waypoint) +
                               " is not a point; its coordinates must be finite"};
        }
        const Vec3& from = plan.moves.front().from;
        if (const auto refusal = check_target(plan, from, waypoint)) return refusal;
    }
    return std::nullopt;
}

std::variant<PlannedDrag, DragRefusal> plan_drag(const DragPlan& plan) {
    return Planner(plan).run();
}

FoldGuard::FoldGuard(const DragSolver& solver) {
    proofs_.push_back({std::vector<Vec3>(solver.field().move_count(), Vec3{0.0})});
}

void FoldGuard::bound_moves(const DragStep& of_solver) {
    DragStep step = of_solver;
    bounds_.assign(step.displacements.size(), 0.0);
    const bool is_tight = bounds_.size() <= kMostTightBounds;
    for (std::size_t m = 0; m < bounds_.size(); ++m) {
        if (!is_tight) {  // both sides add up
            bounds_[m] = (step.symmetry ? 2.0 : 1.0) * step.field.gradient_bound(m);
            continue;
        }
        // Any unit vector that the move's parity allows.
        Vec3 unit{0.0};
        const int across = step.symmetry ? step.symmetry->plane.axis : 0;
        const bool is_odd = step.symmetry && step.symmetry->parity[m] < 0.0;
        unit[is_odd || !step.symmetry ? across : (across + 1) % 3] = 1.0;
        std::fill(step.displacements.begin(), step.displacements.end(), Vec3{0.0});
        step.displacements[m] = unit;
        bounds_[m] = pectin::gradient_bound(step.lattice_fields());
    }
}

double FoldGuard::steepness_by(const Proof& proof, std::span<const Vec3> displacements) const {
    double along = 0.0, squared = 0.0;
    for (std::size_t m = 0; m < bounds_.size(); ++m) {
        along += glm::dot(displacements[m], proof.displacements[m]);
        squared += glm::dot(proof.displacements[m], proof.displacements[m]);
    }
    const double t = squared > 0.0 ? std::max(0.0, along / squared) : 0.0;
    double steepness = t * proof.steepness;
    for (std::size_t m = 0; m < bounds_.size(); ++m) {
        steepness += bounds_[m] * glm::length(displacements[m] - t * proof.displacements[m]);
    }
    return steepness;
}

double FoldGuard::limit(const DragStep& step) {
    if (bounds_.empty()) bound_moves(step);
    assert(bounds_.size() == step.displacements.size());
    for (const Proof& proof : proofs_) {
        const double steepness = steepness_by(proof, step.displacements);
        if (steepness <= (1.0 - kLeastStretch) * (1.0 - kRounding)) return 1.0;
    }
    const double found = injective_limit(step.lattice_fields(), kProofMargin);
    if (next_ == proofs_.size()) proofs_.emplace_back();
    proofs_[next_] = {step.displacements, (1.0 - kLeastStretch) / found};
    next_ = next_ == kProofsKept ? 1 : next_ + 1;
    return std::min(1.0, found);
}

}  // namespace pectin

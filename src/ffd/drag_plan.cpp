#include "ffd/drag_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ffd/fold_guard.h"

namespace pectin {
namespace {

bool is_on_plane(const DragPlan& plan, const Vec3& point) {
    return std::abs(plan.plane->offset(point)) <=
           kOnPlaneFraction * plan.lattice.cell[plan.plane->axis];
}

std::optional<DragRefusal> check_target(const DragPlan& plan, const Vec3& from, const Vec3& to) {
    const auto& plane = plan.plane;
    if (plane && plane->offset(from) * plane->offset(to) < 0.0 && !is_on_plane(plan, from)) {
        return refuse::across_plane(*plane, from, to);
    }
    if (plane && plan.fold_free && is_on_plane(plan, to) && !is_on_plane(plan, from)) {
        return refuse::onto_plane(to);
    }
    if (!plan.fold_free || plan.is_centred_on_point || plan.lattice.influences(to) ||
        (plane && plan.lattice.influences(plane->image(to)))) {
        return std::nullopt;
    }
    return refuse::target_outside_zone(to, plan.lattice.influenced_zone());
}

class Planner {
  public:
    explicit Planner(const DragPlan& plan) : plan_(plan) {
        for (const Move& move : plan_.moves) handles_.push_back({move.from});
        warp_.moves_middles_most = plan_.fold_free && plan_.is_centred_on_point &&
                                   plan_.pins.empty() && plan_.moves.size() == 1 &&
                                   !rotates(plan_.moves.front()) && plan_.falloff == Falloff::sharp;
    }

    std::variant<PlannedDrag, DragRefusal> run() {
        if (handles_.empty()) return refuse::no_handle();
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
    // The first move goes from a to b. In the last segment everything else happens, too.
    std::optional<DragRefusal> segment(const Vec3& a, const Vec3& b, bool is_last) {
        double done = 0.0;
        std::size_t pieces = 1;  // into which the remaining part is divided
        while (true) {
            if (auto refusal = solve_at(a, b, done, is_last)) return refusal;
            const auto motions = [&](std::size_t of) {
                return motions_between(a, b, done, of == 1 ? 1.0 : done + (1.0 - done) / double(of),
                                       is_last);
            };
            if (auto refusal = solver_->check(motions(1))) return on_the_way(*refusal, b, is_last);
            if (warp_.steps.size() == kMaxSteps) return refuse::too_many_waypoints(kMaxSteps);
            if (plan_.fold_free) {
                const auto enough = enough_pieces(pieces, done, motions, is_last);
                if (!enough) return refuse::too_many_steps(target(b, is_last), kMaxSteps);
                pieces = *enough;
            }
            points_.push_back(handles_.front().point);
            warp_.steps.push_back(solver_->deformation(motions(pieces)));
            if (pieces == 1) return std::nullopt;
            done += (1.0 - done) / static_cast<double>(pieces);
            --pieces;
        }
    }

    // Returns the least number of equal steps, `pieces` or more, of which the next one is proven to
    // be free of folds. Returns nothing if that takes more steps than are allowed.
    template <typename Motions>
    std::optional<std::size_t> enough_pieces(std::size_t pieces, double done,
                                             const Motions& motions, bool is_last) {
        const std::size_t most = kMaxSteps - warp_.steps.size();
        for (const Move& move : plan_.moves) {
            if (is_last) pieces = std::max(pieces, least_steps(move, 1.0 - done));
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

    // The target of the move that goes farthest in the segment to b.
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

    DragRefusal on_the_way(DragRefusal refusal, const Vec3& b, bool is_last) const {
        if (warp_.steps.empty()) return refusal;
        return refuse::on_the_way_to(target(b, is_last), refusal);
    }

    static Vec3 between(const Vec3& a, const Vec3& b, double fraction) {
        return fraction == 1.0 ? b : a + fraction * (b - a);
    }
    Vec3 point_of(std::size_t move, const Vec3& a, const Vec3& b, double fraction,
                  bool is_last) const {
        if (move == 0) return between(a, b, fraction);
        const Vec3& from = plan_.moves[move].from;
        return is_last ? between(from, plan_.moves[move].to, fraction) : from;
    }

    std::optional<DragRefusal> solve_at(const Vec3& a, const Vec3& b, double done, bool is_last) {
        for (std::size_t m = 0; m < handles_.size(); ++m) {
            handles_[m] = {point_of(m, a, b, done, is_last), is_last && rotates(plan_.moves[m])};
        }
        Lattice lattice = plan_.lattice;
        if (plan_.is_centred_on_point && handles_.front().point != plan_.moves.front().from) {
            lattice.origin =
                handles_.front().point - 0.5 * Vec3{lattice.deformable - 1} * lattice.cell;
        }
        auto solved =
            DragSolver::create(lattice, handles_, plan_.pins, plan_.plane,
                               plan_.fold_free ? kMaxFoldFreeGain : kMaxControlGain, plan_.falloff);
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
            motions.push_back({to - handles_[m].point,
                               is_last ? jacobian(plan_.moves[m], next - done) : Mat3{1.0}});
        }
        return motions;
    }

    const DragPlan& plan_;
    std::vector<Handle> handles_;  // at their positions before the next step
    Warp warp_;
    std::vector<Vec3> points_;
    std::optional<DragSolver> solver_;
};

}  // namespace

std::optional<DragRefusal> check_drag(const DragPlan& plan) {
    for (const Move& move : plan.moves) {
        if (!has_valid_rotation(move)) return refuse::invalid_rotation(move);
        if (const auto refusal = check_target(plan, move.from, move.to)) return refusal;
    }
    for (const Vec3& waypoint : plan.via) {
        if (!is_finite(waypoint)) {
            return refuse::invalid_waypoint(waypoint);
        }
        const Vec3& from = plan.moves.front().from;
        if (const auto refusal = check_target(plan, from, waypoint)) return refusal;
    }
    return std::nullopt;
}

std::variant<PlannedDrag, DragRefusal> plan_drag(const DragPlan& plan) {
    return Planner(plan).run();
}

}  // namespace pectin

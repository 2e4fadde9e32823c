#include "ffd/drag_solver.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <unordered_map>
#include <utility>

#include "geometry/decimal.h"

namespace pectin {
namespace {

// --- Words for the user ---

DragRefusal refuse_lattice() {
    return {"the lattice needs a finite origin, cells greater than 0 and " +
            std::to_string(kMinDeformable) + " to " + std::to_string(kMaxDeformable) +
            " deformable control points per axis"};
}

DragRefusal refuse_outside(const Vec3& point, const Box& zone) {
    return {"move point " + decimal(point) + " is not inside the influenced zone " +
            decimal(zone.min) + " to " + decimal(zone.max) +
            "; move the cage so that the point lies inside, or drag a point that does"};
}

DragRefusal refuse_border(const Vec3& point, const Box& zone, double max_gain) {
    return {"move point " + decimal(point) + " is too close to the border of the influenced zone " +
            decimal(zone.min) + " to " + decimal(zone.max) + ": a control point would move over " +
            decimal(max_gain) +
            " times as far; stay away from the border, or take a larger cage or radius"};
}

DragRefusal refuse_dependent(const Vec3& a, const Vec3& b, std::size_t constraints,
                             std::size_t controls) {
    const std::string points = a == b ? decimal(a) : decimal(a) + " and " + decimal(b);
    if (constraints > controls) {
        return {"the moves and pins set " + std::to_string(constraints) +
                " conditions, more than the " + std::to_string(controls) +
                (controls == 1 ? " control point" : " control points") +
                " of the lattice can meet, " + points +
                " above all; take fewer of them or a finer lattice"};
    }
    return {"the lattice cannot tell the moves and pins at " + points +
            " apart well enough to meet both; drop one of them or take a finer lattice"};
}

DragRefusal refuse_many() {
    return {"a drag can move and pin at most " + std::to_string(kMaxConstraints) +
            " different points; take fewer of them"};
}

DragRefusal refuse_target(const Vec3& point, const Vec3& d) {
    return {"move point " + decimal(point) + " cannot move by " + decimal(d) +
            "; the place it moves to must be finite"};
}

DragRefusal refuse_difference(const Vec3& point, const Vec3& a, const Vec3& b) {
    return {"move point " + decimal(point) + " is asked to move by " + decimal(a) + " and by " +
            decimal(b) + "; moves of one point must agree"};
}

DragRefusal refuse_rotation(const Vec3& point) {
    return {"the lattice has too few control points about " + decimal(point) +
            " to twist or scale there; take a larger span, or more control points an axis"};
}

DragRefusal refuse_jacobian(const Vec3& point) {
    return {"move point " + decimal(point) +
            " is asked to turn in different ways; moves of one point must agree"};
}

DragRefusal refuse_off_plane(const MirrorPlane& plane, const Vec3& point, const Vec3& d) {
    return {"move point " + decimal(point) +
            " is on the symmetry plane and can only move within it, for instance to " +
            decimal(plane.onto(point + d)) + ", not to " + decimal(point + d) +
            "; or switch symmetry off"};
}

DragRefusal refuse_near_plane(const MirrorPlane& plane, const Vec3& point) {
    return {"move point " + decimal(point) +
            " is so close to the symmetry plane that moving it and its image apart would tear the "
            "object; take the point on the plane, " +
            decimal(plane.onto(point)) + ", or one farther away from it"};
}

DragRefusal refuse_asymmetric_rotation(const MirrorPlane& plane, const Vec3& point) {
    return {"move point " + decimal(point) +
            " is on the symmetry plane and can only be twisted about its normal, " +
            std::string("xyz").substr(static_cast<std::size_t>(plane.axis), 1) +
            "; take that axis, or switch symmetry off"};
}

DragRefusal refuse_pinned(const Vec3& point, const Vec3& d) {
    return {"move point " + decimal(point) + " is pinned and asked to move by " + decimal(d) +
            "; take the pin away or do not move the point"};
}

// --- Constraints ---

std::optional<DragRefusal> check_pins(std::span<const Vec3> pins) {
    const auto wrong = std::find_if_not(pins.begin(), pins.end(), is_finite);
    if (wrong == pins.end()) return std::nullopt;
    return DragRefusal{"pin " + decimal(*wrong) +
                       " is not a point; its coordinates must be finite"};
}

// The pair of constraints whose rows are the most nearly parallel.
std::pair<std::size_t, std::size_t> most_dependent(const Eigen::MatrixXd& gram) {
    std::pair<std::size_t, std::size_t> worst{0, 0};
    double largest = -1.0;
    for (Eigen::Index i = 0; i < gram.rows(); ++i) {
        for (Eigen::Index j = i + 1; j < gram.cols(); ++j) {
            if (!(std::abs(gram(i, j)) > largest)) continue;
            largest = std::abs(gram(i, j));
            worst = {static_cast<std::size_t>(i), static_cast<std::size_t>(j)};
        }
    }
    return worst;
}

// BBᵀ with B's rows scaled to unit length, so that a pin near the border, whose basis values are
// tiny, is as well conditioned as any other.
Eigen::MatrixXd normalised_gram(std::span<const Constraint> rows) {
    const auto size = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd gram(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) {
            gram(i, j) = gram(j, i) =
                dot(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
        }
    }
    return gram;
}

// The first `driven` rows of the inverse Gram matrix, each scaled to what its row is asked for:
// column-major, rows × driven.
std::variant<Eigen::MatrixXd, DragRefusal> invert(std::span<const Constraint> rows,
                                                  std::size_t driven, const Lattice& lattice) {
    const Eigen::MatrixXd gram = normalised_gram(rows);
    const Eigen::LDLT<Eigen::MatrixXd> factors(gram);
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() >= kMinIndependence)) {
        const auto [a, b] = most_dependent(gram);
        return refuse_dependent(rows[a].key.point, rows[b].key.point, rows.size(),
                                lattice.control_count());
    }
    const auto count = static_cast<Eigen::Index>(driven);
    Eigen::MatrixXd solved = factors.solve(Eigen::MatrixXd::Identity(gram.rows(), count));
    for (Eigen::Index m = 0; m < count; ++m) {
        solved.col(m) /= rows[static_cast<std::size_t>(m)].length;
    }
    return solved;
}

}  // namespace

// --- From grips and pins to the field ---

class DragSolver::Builder {
  public:
    Builder(const Lattice& lattice, const std::optional<MirrorPlane>& plane, double max_gain)
        : lattice_(lattice), plane_(plane), max_gain_(max_gain) {}

    std::variant<DragSolver, DragRefusal> build(std::span<const Handle> handles,
                                                std::span<const Vec3> pins) {
        if (handles.empty()) return DragRefusal{"a drag needs at least one point to move"};
        for (const Handle& handle : handles) {
            if (const auto refusal = add_handle(handle)) return *refusal;
        }
        const std::size_t driven = constraints_.size();
        for (const Vec3& pin : pins) {
            if (const auto refusal = add_pin(canonical(pin))) return *refusal;
        }
        auto solved = invert(constraints_, driven, lattice_);
        if (const auto* refusal = std::get_if<DragRefusal>(&solved)) return *refusal;
        return DragSolver{make_field(std::get<Eigen::MatrixXd>(solved)), symmetry(),
                          std::move(moves_), std::move(columns_)};
    }

  private:
    // On the plane's positive side, or on the plane.
    Vec3 canonical(const Vec3& point) const {
        if (!plane_) return point;
        if (is_on_plane(point)) return plane_->onto(point);
        return plane_->offset(point) < 0.0 ? plane_->image(point) : point;
    }
    bool is_on_plane(const Vec3& point) const {
        return plane_ &&
               std::abs(plane_->offset(point)) <= kOnPlaneFraction * lattice_.cell[plane_->axis];
    }
    bool is_reached(const Vec3& point) const {
        return lattice_.influences(point) || (plane_ && lattice_.influences(plane_->image(point)));
    }
    std::span<const double> parities() const {
        static constexpr std::array<double, 2> kBoth{1.0, -1.0};
        return std::span(kBoth).first(plane_ ? 2 : 1);
    }
    struct Hash {
        std::size_t operator()(const ConstraintKey& key) const {
            std::size_t hash = std::hash<int>()(key.along);
            for (const double x : {key.point.x, key.point.y, key.point.z, key.parity}) {
                hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(x);
            }
            return hash;
        }
    };
    using Indices = std::unordered_map<ConstraintKey, std::size_t, Hash>;
    std::size_t add_constraint(const Constraint& constraint) {
        rows_.emplace(constraint.key, constraints_.size());
        constraints_.push_back(constraint);
        return constraints_.size() - 1;
    }

    std::optional<DragRefusal> add_handle(const Handle& handle) {
        const Box zone = lattice_.influenced_zone();
        if (!is_reached(handle.point)) return refuse_outside(handle.point, zone);
        Move move{.asked = handle.point,
                  .point = canonical(handle.point),
                  .prescribes_jacobian = handle.prescribes_jacobian};
        move.is_on_plane = is_on_plane(handle.point);
        move.is_flipped = plane_ && !move.is_on_plane && plane_->offset(handle.point) < 0.0;
        const ConstraintKey key{move.point};
        move.first_at_point = first_moves_.emplace(key, moves_.size()).first->second;
        if (move.prescribes_jacobian) {
            move.first_jacobian = first_jacobians_.emplace(key, moves_.size()).first->second;
        }
        for (const double parity : parities()) {
            const double gain = add_column({move.point, -1, parity});
            if (parity < 0.0) {
                move.is_near_plane = !move.is_on_plane && !(gain <= kMaxControlGain);
            } else if (!(gain <= max_gain_)) {
                return refuse_border(handle.point, zone, max_gain_);
            }
        }
        for (int along = 0; handle.prescribes_jacobian && along < 3; ++along) {
            for (const double parity : parities()) {
                const double gain = add_column({move.point, along, parity});
                const bool vanishes = move.is_on_plane && std::isnan(gain);
                if (!vanishes && !(gain <= kMaxControlGain * lattice_.cell[along])) {
                    return refuse_rotation(handle.point);
                }
            }
        }
        moves_.push_back(move);
        if (constraints_.size() > kMaxConstraints) return refuse_many();
        return std::nullopt;
    }

    // A driven row, unless an earlier move drives it, and its gain: not a number where the lattice
    // cannot bring it about.
    double add_column(const ConstraintKey& key) {
        if (const auto found = rows_.find(key); found != rows_.end()) return gains_[found->second];
        const Constraint constraint = make_constraint(lattice_, plane_, key);
        if (!(constraint.length > 0.0)) return std::nan("");
        add_constraint(constraint);
        gains_.push_back(constraint.control_gain());
        columns_.push_back({moves_.size(), key});
        return gains_.back();
    }

    std::optional<DragRefusal> add_pin(const Vec3& pin) {
        if (const auto there = first_moves_.find(ConstraintKey{pin}); there != first_moves_.end()) {
            moves_[there->second].is_pinned = true;
        }
        if (!is_reached(pin)) return std::nullopt;
        for (const double parity : parities()) {
            const ConstraintKey key{pin, -1, parity};
            if (rows_.contains(key)) continue;
            const Constraint constraint = make_constraint(lattice_, plane_, key);
            if (constraint.length > 0.0) add_constraint(constraint);
        }
        if (constraints_.size() > kMaxConstraints) return refuse_many();
        return std::nullopt;
    }

    // One row of the inverse for every column.
    DragField make_field(const Eigen::MatrixXd& solved) const {
        std::vector<BasisRow> rows;
        for (const Constraint& constraint : constraints_) {
            for (std::size_t t = 0; t < constraint.term_count; ++t) {
                rows.push_back(constraint.terms[t].row);
            }
        }
        std::vector<double> inverse;
        inverse.reserve(rows.size() * static_cast<std::size_t>(solved.cols()));
        for (Eigen::Index driven = 0; driven < solved.cols(); ++driven) {
            for (std::size_t a = 0; a < constraints_.size(); ++a) {
                const double entry = solved(static_cast<Eigen::Index>(a), driven);
                for (std::size_t t = 0; t < constraints_[a].term_count; ++t) {
                    inverse.push_back(entry * constraints_[a].terms[t].factor);
                }
            }
        }
        return {lattice_, std::move(rows), std::move(inverse)};
    }

    std::optional<Symmetry> symmetry() const {
        if (!plane_) return std::nullopt;
        Symmetry symmetry{*plane_, {}};
        for (const Column& column : columns_) {
            // Like the row of the derivative, w takes its sign from the components it moves.
            symmetry.parity.push_back(column.key.parity);
        }
        return symmetry;
    }

    const Lattice& lattice_;
    const std::optional<MirrorPlane>& plane_;
    double max_gain_;
    std::vector<Constraint> constraints_;  // the driven ones first, one a column
    std::vector<double> gains_;            // of the driven ones
    Indices rows_;                         // of the constraints
    std::vector<Column> columns_;
    std::vector<Move> moves_;
    Indices first_moves_;      // of points, the first move there
    Indices first_jacobians_;  // of points, the first move there that prescribes its Jacobian
};

DragSolver::DragSolver(DragField field, std::optional<Symmetry> symmetry, std::vector<Move> moves,
                       std::vector<Column> columns)
    : field_(std::move(field)),
      symmetry_(std::move(symmetry)),
      moves_(std::move(moves)),
      columns_(std::move(columns)) {}

std::variant<DragSolver, DragRefusal> DragSolver::create(const Lattice& lattice,
                                                         std::span<const Handle> handles,
                                                         std::span<const Vec3> pins,
                                                         const std::optional<MirrorPlane>& plane,
                                                         double max_gain) {
    if (!lattice.is_valid()) return refuse_lattice();
    if (const auto refusal = check_pins(pins)) return *refusal;
    return Builder(lattice, plane, max_gain).build(handles, pins);
}

std::variant<DragSolver, DragRefusal> DragSolver::create(const Lattice& lattice,
                                                         std::span<const Vec3> move_points,
                                                         std::span<const Vec3> pins) {
    std::vector<Handle> handles;
    for (const Vec3& point : move_points) handles.push_back({point});
    return create(lattice, handles, pins);
}

// --- What is asked ---

HandleMotion DragSolver::on_positive_side(const Move& move, const HandleMotion& motion) const {
    if (!move.is_flipped) return motion;
    const MirrorPlane& plane = symmetry_->plane;
    return {plane.image_of_vector(motion.displacement), plane.image_of_jacobian(motion.jacobian)};
}

std::optional<DragRefusal> DragSolver::check_symmetry(const Move& move,
                                                      const HandleMotion& motion) const {
    const MirrorPlane& plane = symmetry_->plane;
    const Vec3& d = motion.displacement;
    if (move.is_on_plane && d[plane.axis] != 0.0) return refuse_off_plane(plane, move.asked, d);
    if (move.is_near_plane && d[plane.axis] != 0.0) return refuse_near_plane(plane, move.asked);
    if (!move.is_on_plane || !move.prescribes_jacobian) return std::nullopt;
    const Mat3 difference = plane.image_of_jacobian(motion.jacobian) - motion.jacobian;
    for (int column = 0; column < 3; ++column) {
        // What rounding leaves of a twist about the normal is no asymmetry.
        if (glm::length(difference[column]) > 1e-12) {
            return refuse_asymmetric_rotation(plane, move.asked);
        }
    }
    return std::nullopt;
}

std::optional<DragRefusal> DragSolver::check(std::span<const HandleMotion> motions) const {
    assert(motions.size() == moves_.size());
    for (std::size_t m = 0; m < moves_.size(); ++m) {
        const Move& move = moves_[m];
        const Vec3& d = motions[m].displacement;
        if (!is_finite(move.asked + d)) return refuse_target(move.asked, d);
        const HandleMotion here = on_positive_side(move, motions[m]);
        const Move& first = moves_[move.first_at_point];
        const HandleMotion there = on_positive_side(first, motions[move.first_at_point]);
        if (here.displacement != there.displacement) {
            return refuse_difference(move.asked, motions[move.first_at_point].displacement, d);
        }
        if (move.prescribes_jacobian) {
            const Move& other = moves_[move.first_jacobian];
            const HandleMotion asked = on_positive_side(other, motions[move.first_jacobian]);
            if (here.jacobian != asked.jacobian) return refuse_jacobian(move.asked);
        }
        if (first.is_pinned && d != Vec3{0.0}) return refuse_pinned(move.asked, d);
        if (!symmetry_) continue;
        if (const auto refusal = check_symmetry(move, motions[m])) return refusal;
    }
    return std::nullopt;
}

std::optional<DragRefusal> DragSolver::check(std::span<const Vec3> displacements) const {
    std::vector<HandleMotion> motions;
    for (const Vec3& d : displacements) motions.push_back({d});
    return check(motions);
}

std::vector<Vec3> DragSolver::field_displacements(std::span<const HandleMotion> motions) const {
    assert(motions.size() == moves_.size());
    std::vector<Vec3> asked;
    for (const auto& [m, key] : columns_) {
        const HandleMotion motion = on_positive_side(moves_[m], motions[m]);
        Vec3 d = motion.displacement;
        if (key.along >= 0) d = (motion.jacobian - Mat3{1.0})[key.along];
        if (symmetry_) {
            const int axis = symmetry_->plane.axis;
            for (int i = 0; i < 3; ++i) {
                if ((i == axis) != (key.parity < 0.0)) d[i] = 0.0;
            }
        }
        asked.push_back(d);
    }
    return asked;
}

std::vector<Vec3> DragSolver::control_displacements(std::span<const Vec3> displacements) const {
    assert(!check(displacements));
    std::vector<HandleMotion> motions;
    for (const Vec3& d : displacements) motions.push_back({d});
    return field_.control_displacements(field_displacements(motions));
}

}  // namespace pectin

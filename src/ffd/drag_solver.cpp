#include "ffd/drag_solver.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <unordered_map>
#include <utility>

#include "ffd/plateau.h"

namespace pectin {
namespace {

// The pair of constraints whose rows are most nearly parallel.
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

// BBᵀ with the rows of B scaled to unit length. A pin near the border, whose basis values are tiny,
// is then as well conditioned as any other.
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

using Factors = Eigen::LDLT<Eigen::MatrixXd>;

std::variant<Factors, DragRefusal> factorise(std::span<const Constraint> rows,
                                             const Lattice& lattice) {
    const Eigen::MatrixXd gram = normalised_gram(rows);
    Factors factors(gram);
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() >= kMinIndependence)) {
        const auto [a, b] = most_dependent(gram);
        return refuse::dependent(rows[a].key.point, rows[b].key.point, rows.size(),
                                 lattice.control_count());
    }
    return factors;
}

// The first `driven` columns of the inverse Gram matrix, each divided by the length of its row, so
// that they apply to displacements: rows × driven, column-major.
Eigen::MatrixXd invert(const Factors& factors, std::span<const Constraint> rows,
                       std::size_t driven) {
    const auto count = static_cast<Eigen::Index>(driven);
    Eigen::MatrixXd solved = factors.solve(Eigen::MatrixXd::Identity(factors.rows(), count));
    for (Eigen::Index m = 0; m < count; ++m) {
        solved.col(m) /= rows[static_cast<std::size_t>(m)].length;
    }
    return solved;
}

}  // namespace

// --- From handles and pins to the field

class DragSolver::Builder {
  public:
    Builder(const Lattice& lattice, const std::optional<MirrorPlane>& plane, double max_gain,
            Falloff falloff)
        : lattice_(lattice), plane_(plane), max_gain_(max_gain), falloff_(falloff) {}

    std::variant<DragSolver, DragRefusal> build(std::span<const Handle> handles,
                                                std::span<const Vec3> pins) {
        if (handles.empty()) return refuse::no_handle();
        for (const Handle& handle : handles) {
            if (const auto refusal = add_handle(handle)) return *refusal;
        }
        const std::size_t driven = constraints_.size();
        for (const Vec3& pin : pins) {
            if (const auto refusal = add_pin(canonical(pin))) return *refusal;
        }
        auto factorised = factorise(constraints_, lattice_);
        if (const auto* refusal = std::get_if<DragRefusal>(&factorised)) return *refusal;
        const Factors& factors = std::get<Factors>(factorised);
        DragField field = falloff_ == Falloff::plateau
                              ? plateau_field(factors, driven)
                              : make_field(invert(factors, constraints_, driven));
        return DragSolver{std::move(field), symmetry(), std::move(handles_), std::move(driven_)};
    }

  private:
    // The point or its mirror image, whichever is on the plane's positive side or on the plane.
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
        if (!is_reached(handle.point)) return refuse::outside_zone(handle.point, zone);
        CanonicalHandle added{.given = handle.point,
                              .point = canonical(handle.point),
                              .prescribes_jacobian = handle.prescribes_jacobian};
        added.is_on_plane = is_on_plane(handle.point);
        added.is_flipped = plane_ && !added.is_on_plane && plane_->offset(handle.point) < 0.0;
        const ConstraintKey key{added.point};
        added.first_at_point = first_handles_.emplace(key, handles_.size()).first->second;
        if (added.prescribes_jacobian) {
            added.first_jacobian = first_jacobians_.emplace(key, handles_.size()).first->second;
        }
        for (const double parity : parities()) {
            const double gain = add_driven({added.point, -1, parity});
            if (parity < 0.0) {
                added.is_near_plane = !added.is_on_plane && !(gain <= kMaxControlGain);
            } else if (!(gain <= max_gain_)) {
                return refuse::near_border(handle.point, zone, max_gain_);
            }
        }
        for (int along = 0; handle.prescribes_jacobian && along < 3; ++along) {
            for (const double parity : parities()) {
                const double gain = add_driven({added.point, along, parity});
                const bool vanishes = added.is_on_plane && std::isnan(gain);
                if (!vanishes && !(gain <= kMaxControlGain * lattice_.cell[along])) {
                    return refuse::too_coarse_to_rotate(handle.point);
                }
            }
        }
        handles_.push_back(added);
        if (constraints_.size() > kMaxConstraints)
            return refuse::too_many_constraints(kMaxConstraints);
        return std::nullopt;
    }

    // Adds a driven constraint unless an earlier handle drives it. Returns its gain, which is not a
    // number if the lattice cannot meet the constraint.
    double add_driven(const ConstraintKey& key) {
        if (const auto found = rows_.find(key); found != rows_.end()) return gains_[found->second];
        const Constraint constraint = make_constraint(lattice_, plane_, key);
        if (!(constraint.length > 0.0)) return std::nan("");
        add_constraint(constraint);
        gains_.push_back(constraint.control_gain());
        driven_.push_back({handles_.size(), key});
        return gains_.back();
    }

    std::optional<DragRefusal> add_pin(const Vec3& pin) {
        if (const auto there = first_handles_.find(ConstraintKey{pin});
            there != first_handles_.end()) {
            handles_[there->second].is_pinned = true;
        }
        if (!is_reached(pin)) return std::nullopt;
        for (const double parity : parities()) {
            const ConstraintKey key{pin, -1, parity};
            if (rows_.contains(key)) continue;
            const Constraint constraint = make_constraint(lattice_, plane_, key);
            if (constraint.length > 0.0) add_constraint(constraint);
        }
        if (constraints_.size() > kMaxConstraints)
            return refuse::too_many_constraints(kMaxConstraints);
        return std::nullopt;
    }

    // The field has one row of the inverse for each driven constraint.
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

    DragField plateau_field(const Factors& factors, std::size_t driven) const {
        const auto solve = [&](const std::vector<double>& right) {
            std::vector<double> solution(right.size());
            const auto size = static_cast<Eigen::Index>(right.size());
            Eigen::Map<Eigen::VectorXd>(solution.data(), size) =
                factors.solve(Eigen::Map<const Eigen::VectorXd>(right.data(), size));
            return solution;
        };
        return {lattice_, plateau_weights(lattice_, plane_, constraints_, driven, solve)};
    }

    std::optional<Symmetry> symmetry() const {
        if (!plane_) return std::nullopt;
        Symmetry symmetry{*plane_, {}};
        for (const DrivenConstraint& driven : driven_) {
            // Like the row of the derivative, w has the sign of the components that it moves.
            symmetry.parity.push_back(driven.key.parity);
        }
        return symmetry;
    }

    const Lattice& lattice_;
    const std::optional<MirrorPlane>& plane_;
    double max_gain_;
    Falloff falloff_;
    std::vector<Constraint> constraints_;  // first the driven ones, in the order of driven_
    std::vector<double> gains_;            // of the driven ones
    Indices rows_;                         // the indices of constraints
    std::vector<DrivenConstraint> driven_;
    std::vector<CanonicalHandle> handles_;
    Indices first_handles_;    // the first handle at each point
    Indices first_jacobians_;  // the first handle at each point that prescribes its Jacobian
};

DragSolver::DragSolver(DragField field, std::optional<Symmetry> symmetry,
                       std::vector<CanonicalHandle> handles, std::vector<DrivenConstraint> driven)
    : field_(std::move(field)),
      symmetry_(std::move(symmetry)),
      handles_(std::move(handles)),
      driven_(std::move(driven)) {}

std::variant<DragSolver, DragRefusal> DragSolver::create(const Lattice& lattice,
                                                         std::span<const Handle> handles,
                                                         std::span<const Vec3> pins,
                                                         const std::optional<MirrorPlane>& plane,
                                                         double max_gain, Falloff falloff) {
    if (!lattice.is_valid()) return refuse::invalid_lattice();
    const auto invalid_pin = std::find_if_not(pins.begin(), pins.end(), is_finite);
    if (invalid_pin != pins.end()) return refuse::invalid_pin(*invalid_pin);
    return Builder(lattice, plane, max_gain, falloff).build(handles, pins);
}

std::variant<DragSolver, DragRefusal> DragSolver::create(const Lattice& lattice,
                                                         std::span<const Vec3> points,
                                                         std::span<const Vec3> pins) {
    std::vector<Handle> handles;
    for (const Vec3& point : points) handles.push_back({point});
    return create(lattice, handles, pins);
}

// --- Motions of the handles

HandleMotion DragSolver::on_positive_side(const CanonicalHandle& handle,
                                          const HandleMotion& motion) const {
    if (!handle.is_flipped) return motion;
    const MirrorPlane& plane = symmetry_->plane;
    return {plane.image_of_vector(motion.displacement), plane.image_of_jacobian(motion.jacobian)};
}

std::optional<DragRefusal> DragSolver::check_symmetry(const CanonicalHandle& handle,
                                                      const HandleMotion& motion) const {
    const MirrorPlane& plane = symmetry_->plane;
    const Vec3& d = motion.displacement;
    if (handle.is_on_plane && d[plane.axis] != 0.0)
        return refuse::off_plane(plane, handle.given, d);
    if (handle.is_near_plane && d[plane.axis] != 0.0)
        return refuse::near_plane(plane, handle.given);
    if (!handle.is_on_plane || !handle.prescribes_jacobian) return std::nullopt;
    const Mat3 difference = plane.image_of_jacobian(motion.jacobian) - motion.jacobian;
    for (int column = 0; column < 3; ++column) {
        // The rounding errors of a twist about the normal are not an asymmetry.
        if (glm::length(difference[column]) > 1e-12) {
            return refuse::asymmetric_rotation(plane, handle.given);
        }
    }
    return std::nullopt;
}

// Handles at the same point must be asked for the same motion.
std::optional<DragRefusal> DragSolver::check_agreement(
    std::size_t handle, std::span<const HandleMotion> motions) const {
    const CanonicalHandle& canonical = handles_[handle];
    const auto canonical_motion = [&](std::size_t of) {
        return on_positive_side(handles_[of], motions[of]);
    };
    const HandleMotion asked = canonical_motion(handle);
    const std::size_t first = canonical.first_at_point;
    if (asked.displacement != canonical_motion(first).displacement) {
        return refuse::different_displacements(canonical.given, motions[first].displacement,
                                               motions[handle].displacement);
    }
    if (canonical.prescribes_jacobian &&
        asked.jacobian != canonical_motion(canonical.first_jacobian).jacobian) {
        return refuse::different_rotations(canonical.given);
    }
    return std::nullopt;
}

std::optional<DragRefusal> DragSolver::check(std::span<const HandleMotion> motions) const {
    assert(motions.size() == handles_.size());
    for (std::size_t h = 0; h < handles_.size(); ++h) {
        const CanonicalHandle& handle = handles_[h];
        const Vec3& d = motions[h].displacement;
        if (!is_finite(handle.given + d)) return refuse::not_finite(handle.given, d);
        if (const auto refusal = check_agreement(h, motions)) return refusal;
        if (handles_[handle.first_at_point].is_pinned && d != Vec3{0.0}) {
            return refuse::pinned(handle.given, d);
        }
        if (!symmetry_) continue;
        if (const auto refusal = check_symmetry(handle, motions[h])) return refusal;
    }
    return std::nullopt;
}

std::optional<DragRefusal> DragSolver::check(std::span<const Vec3> displacements) const {
    std::vector<HandleMotion> motions;
    for (const Vec3& d : displacements) motions.push_back({d});
    return check(motions);
}

Vec3 DragSolver::prescribed(const DrivenConstraint& driven,
                            std::span<const HandleMotion> motions) const {
    const auto& [h, key] = driven;
    const HandleMotion motion = on_positive_side(handles_[h], motions[h]);
    Vec3 d = motion.displacement;
    if (key.along >= 0) d = (motion.jacobian - Mat3{1.0})[key.along];
    if (symmetry_) {
        const int axis = symmetry_->plane.axis;
        for (int i = 0; i < 3; ++i) {
            if ((i == axis) != (key.parity < 0.0)) d[i] = 0.0;
        }
    }
    return d;
}

std::vector<Vec3> DragSolver::field_displacements(std::span<const HandleMotion> motions) const {
    assert(motions.size() == handles_.size());
    std::vector<Vec3> displacements;
    for (const DrivenConstraint& driven : driven_) {
        displacements.push_back(prescribed(driven, motions));
    }
    return displacements;
}

void DragSolver::set_motions(std::span<const HandleMotion> motions, DragStep& step) const {
    assert(motions.size() == handles_.size() && step.displacements.size() == driven_.size());
    for (std::size_t i = 0; i < driven_.size(); ++i) {
        step.displacements[i] = prescribed(driven_[i], motions);
    }
}

std::vector<Vec3> DragSolver::displacements(std::span<const HandleMotion> motions) const {
    if (field_.weight_count() <= kMostWeights) return field_displacements(motions);
    const Deformation step = deformation(motions);
    const std::span<const Vec3> all = displacements_of(step);
    return {all.begin(), all.end()};
}

std::vector<Vec3> DragSolver::control_displacements(std::span<const Vec3> displacements) const {
    assert(!check(displacements));
    std::vector<HandleMotion> motions;
    for (const Vec3& d : displacements) motions.push_back({d});
    return field_.control_displacements(field_displacements(motions));
}

}  // namespace pectin

#include "ffd/drag_solver.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
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

DragRefusal refuse_border(const Vec3& point, const Box& zone) {
    return {"move point " + decimal(point) + " is too close to the border of the influenced zone " +
            decimal(zone.min) + " to " + decimal(zone.max) + ": a control point would move over " +
            decimal(kMaxControlGain) + " times as far; move the cage or take a larger radius"};
}

DragRefusal refuse_dependent(const Vec3& a, const Vec3& b, std::size_t constraints,
                             std::size_t controls) {
    const std::string points = decimal(a) + " and " + decimal(b);
    if (constraints > controls) {
        return {std::to_string(constraints) + " moves and pins are more than the " +
                std::to_string(controls) + " control points of the lattice can meet, " + points +
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

DragRefusal refuse_pinned(const Vec3& point, const Vec3& d) {
    return {"move point " + decimal(point) + " is pinned and asked to move by " + decimal(d) +
            "; take the pin away or do not move the point"};
}

// --- Constraints ---

// The distinct constrained points and their rows, moves first.
struct Constraints {
    std::vector<Vec3> points;
    std::vector<BasisRow> rows;

    // Where `point` stands among the points, or their number.
    std::size_t find(const Vec3& point) const {
        return static_cast<std::size_t>(std::find(points.begin(), points.end(), point) -
                                        points.begin());
    }
    // Adds a point unless it is there already or no control point reaches it; returns whether the
    // number of points is still one to work with.
    bool add(const Lattice& lattice, const Vec3& point) {
        if (find(point) < points.size()) return true;
        const BasisRow row = basis_row(lattice, point);
        if (!(row.length > 0.0)) return true;
        points.push_back(point);
        rows.push_back(row);
        return points.size() <= kMaxConstraints;
    }
};

std::optional<DragRefusal> check_moves(const Lattice& lattice, std::span<const Vec3> points) {
    if (points.empty()) return DragRefusal{"a drag needs at least one point to move"};
    const Box zone = lattice.influenced_zone();
    for (const Vec3& point : points) {
        if (!zone.contains_strictly(point)) return refuse_outside(point, zone);
        const double gain = control_gain(basis_row(lattice, point));  // nan for a row of zeros
        if (!(gain <= kMaxControlGain)) return refuse_border(point, zone);
    }
    return std::nullopt;
}

std::optional<DragRefusal> check_pins(std::span<const Vec3> pins) {
    const auto wrong = std::find_if_not(pins.begin(), pins.end(), is_finite);
    if (wrong == pins.end()) return std::nullopt;
    return DragRefusal{"pin " + decimal(*wrong) +
                       " is not a point; its coordinates must be finite"};
}

// The pair of points whose rows are the most nearly parallel.
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
Eigen::MatrixXd normalised_gram(std::span<const BasisRow> rows) {
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

// The first `moves` rows of the inverse Gram matrix, each scaled to the drag of its move.
std::variant<std::vector<double>, DragRefusal> invert(const Constraints& constraints,
                                                      std::size_t moves, const Lattice& lattice) {
    const Eigen::MatrixXd gram = normalised_gram(constraints.rows);
    const Eigen::LDLT<Eigen::MatrixXd> factors(gram);
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() >= kMinIndependence)) {
        const auto [a, b] = most_dependent(gram);
        return refuse_dependent(constraints.points[a], constraints.points[b],
                                constraints.points.size(), lattice.control_count());
    }
    const auto count = static_cast<Eigen::Index>(moves);
    Eigen::MatrixXd solved = factors.solve(Eigen::MatrixXd::Identity(gram.rows(), count));
    for (Eigen::Index m = 0; m < count; ++m) {
        solved.col(m) /= constraints.rows[static_cast<std::size_t>(m)].length;
    }
    return std::vector<double>(solved.data(), solved.data() + solved.size());
}

// One row for every move out of one for every distinct moved point: the first move there has it,
// those that repeat it have zeros, so that the displacement counts once.
std::vector<double> spread(std::span<const double> rows, std::span<const std::size_t> first_there,
                           std::size_t move_count) {
    const std::size_t width = rows.size() / first_there.size();
    std::vector<double> all(move_count * width, 0.0);
    for (std::size_t place = 0; place < first_there.size(); ++place) {
        std::copy_n(&rows[place * width], width, &all[first_there[place] * width]);
    }
    return all;
}

}  // namespace

DragSolver::DragSolver(DragField field, std::vector<Move> moves)
    : field_(std::move(field)), moves_(std::move(moves)) {}

std::variant<DragSolver, DragRefusal> DragSolver::create(const Lattice& lattice,
                                                         std::span<const Vec3> move_points,
                                                         std::span<const Vec3> pins) {
    if (!lattice.is_valid()) return refuse_lattice();
    if (const auto refusal = check_moves(lattice, move_points)) return *refusal;
    if (const auto refusal = check_pins(pins)) return *refusal;

    Constraints constraints;
    std::vector<Move> moves;
    std::vector<std::size_t> first_there;  // of each distinct moved point, the first move
    for (const Vec3& point : move_points) {
        const std::size_t place = constraints.find(point);
        if (place == constraints.points.size()) first_there.push_back(moves.size());
        if (!constraints.add(lattice, point)) return refuse_many();
        moves.push_back({point, first_there[place], false});
    }
    for (const Vec3& pin : pins) {
        if (lattice.influences(pin) && !constraints.add(lattice, pin)) return refuse_many();
    }
    for (Move& move : moves) {
        move.pinned = std::find(pins.begin(), pins.end(), move.point) != pins.end();
    }

    auto inverse = invert(constraints, first_there.size(), lattice);
    if (const auto* refusal = std::get_if<DragRefusal>(&inverse)) return *refusal;
    return DragSolver{DragField{lattice, std::move(constraints.rows),
                                spread(std::get<0>(inverse), first_there, moves.size())},
                      std::move(moves)};
}

std::optional<DragRefusal> DragSolver::check(std::span<const Vec3> displacements) const {
    assert(displacements.size() == moves_.size());
    for (std::size_t m = 0; m < moves_.size(); ++m) {
        const auto& [point, same_place, pinned] = moves_[m];
        const Vec3& d = displacements[m];
        if (!is_finite(point + d)) return refuse_target(point, d);
        if (d != displacements[same_place]) {
            return refuse_difference(point, displacements[same_place], d);
        }
        if (pinned && d != Vec3{0.0}) return refuse_pinned(point, d);
    }
    return std::nullopt;
}

std::vector<Vec3> DragSolver::control_displacements(std::span<const Vec3> displacements) const {
    assert(!check(displacements));
    return field_.control_displacements(displacements);
}

}  // namespace pectin

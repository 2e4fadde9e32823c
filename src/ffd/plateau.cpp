#include "ffd/plateau.h"

#include <algorithm>
#include <cmath>

namespace pectin {
namespace {

// Calls visit(control index, coefficient) for each control point that a row of unit length moves.
template <typename Visit>
void for_each_coefficient(const Lattice& lattice, const Constraint& constraint,
                          const Visit& visit) {
    for (std::size_t t = 0; t < constraint.term_count; ++t) {
        const auto& [first, coefficient, length] = constraint.terms[t].row;
        for (std::size_t flat = 0; flat < 64; ++flat) {
            const std::size_t i = flat % 4, j = flat / 4 % 4, k = flat / 16;
            const double b = coefficient[0][i] * coefficient[1][j] * coefficient[2][k];
            if (b == 0.0) continue;  // not deformable
            const IVec3 control =
                IVec3{first[0], first[1], first[2]} +
                IVec3{static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)};
            visit(lattice.control_index(control), constraint.terms[t].factor * b);
        }
    }
}

std::vector<Vec3> points_of(std::span<const Constraint> constraints) {
    std::vector<Vec3> points;
    for (const Constraint& constraint : constraints) points.push_back(constraint.key.point);
    return points;
}

// Where the block ends, in cells beyond the outermost control points of a lattice around the
// handle, and how wide its edge is. A narrower edge shows the grid: the line of equal weight is
// then uneven.
constexpr double kFadeBeyond = 1.3, kFadeWidth = 2.0;

// Rises smoothly from 0 at s = 0 to 1 at the width of the edge.
double fade(double s) {
    const double t = std::clamp(s / kFadeWidth, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// A weight that changes from 0 to 1 over one cell around s = 0.
double ramp(double s) { return std::clamp(0.5 + s, 0.0, 1.0); }

}  // namespace

PlateauBlocks::PlateauBlocks(const Lattice& lattice, const std::optional<MirrorPlane>& plane,
                             std::span<const Vec3> points)
    : lattice_(lattice), plane_(plane) {
    const Vec3 middle = lattice.origin + 0.5 * Vec3{lattice.deformable - 1} * lattice.cell;
    if (plane_ && plane_->offset(middle) < 0.0) side_ = -1.0;
    for (const Vec3& point : points) {
        const Vec3 own = lattice.parameter(on_own_side(point));
        if (std::ranges::find(points_, own) == points_.end()) points_.push_back(own);
    }
}

Vec3 PlateauBlocks::on_own_side(const Vec3& point) const {
    return plane_ && side_ * plane_->offset(point) < 0.0 ? plane_->image(point) : point;
}

// How much nearer to the handle than to any other point, or to an image, the control point is: 1
// from half a cell on this side of the middle between them, and 0 from half a cell beyond it.
double PlateauBlocks::nearness(const Vec3& control, const Vec3& handle) const {
    double least = 1.0;
    for (const Vec3& other : points_) {
        if (other == handle) continue;
        const Vec3 middle = 0.5 * (handle + other);
        least = std::min(least, ramp(glm::dot(control - middle, glm::normalize(handle - other))));
    }
    if (plane_) {
        const double at = lattice_.parameter(plane_->onto(lattice_.origin))[plane_->axis];
        least = std::min(least, ramp(side_ * (control[plane_->axis] - at)));
    }
    return least;
}

double PlateauBlocks::membership(const IVec3& control, const Vec3& handle) const {
    const IVec3& counts = lattice_.deformable;
    const double half = 0.5 * (std::max({counts.x, counts.y, counts.z}) - 1);
    const double within = fade(half + kFadeBeyond - glm::distance(Vec3{control}, handle));
    return within > 0.0 ? within * nearness(Vec3{control}, handle) : 0.0;
}

std::vector<double> PlateauBlocks::coefficients(const ConstraintKey& key) const {
    const Vec3 own = on_own_side(key.point);
    const Vec3 handle = lattice_.parameter(own);
    // Seen from the image of the point the components across the plane have the opposite sign, and
    // so has the distance along the normal of the plane.
    double sign = own == key.point ? 1.0 : key.parity;
    if (own != key.point && key.along == plane_->axis) sign = -sign;
    std::vector<double> coefficients(lattice_.control_count(), 0.0);
    for (int k = 0; k < lattice_.deformable.z; ++k) {
        for (int j = 0; j < lattice_.deformable.y; ++j) {
            for (int i = 0; i < lattice_.deformable.x; ++i) {
                const IVec3 control{i, j, k};
                double value = sign * membership(control, handle);
                if (key.along >= 0) {
                    value *= (lattice_.rest(control) - own)[key.along];
                }
                coefficients[lattice_.control_index(control)] = value;
            }
        }
    }
    return coefficients;
}

std::vector<WeightSpline> plateau_weights(
    const Lattice& lattice, const std::optional<MirrorPlane>& plane,
    std::span<const Constraint> constraints, std::size_t driven,
    const std::function<std::vector<double>(const std::vector<double>&)>& solve) {
    const PlateauBlocks blocks(lattice, plane, points_of(constraints));
    std::vector<WeightSpline> weights;
    for (std::size_t m = 0; m < driven; ++m) {
        const ConstraintKey& key = constraints[m].key;
        std::vector<double> column = blocks.coefficients(key);  // of P
        // What the block leaves unmet, with the rows scaled to unit length. Constraints of the
        // other parity apply to other components.
        std::vector<double> unmet(constraints.size(), 0.0);
        unmet[m] = 1.0 / constraints[m].length;
        for (std::size_t a = 0; a < constraints.size(); ++a) {
            if (constraints[a].key.parity != key.parity) continue;
            for_each_coefficient(lattice, constraints[a], [&](std::size_t control, double b) {
                unmet[a] -= b * column[control];
            });
        }
        const std::vector<double> factors = solve(unmet);
        for (std::size_t a = 0; a < constraints.size(); ++a) {
            if (constraints[a].key.parity != key.parity) continue;
            for_each_coefficient(lattice, constraints[a], [&](std::size_t control, double b) {
                column[control] += factors[a] * b;
            });
        }
        weights.emplace_back(lattice, column);
    }
    return weights;
}

}  // namespace pectin

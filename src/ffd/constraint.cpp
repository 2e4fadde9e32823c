#include "ffd/constraint.h"

#include <algorithm>
#include <cmath>

namespace pectin {
namespace {

BasisRow row_at(const Lattice& lattice, const Vec3& x, int along) {
    if (!lattice.influences(x)) return {};
    return along < 0 ? basis_row(lattice, x) : basis_derivative_row(lattice, x, along);
}

// The coefficient of the control point with these indices.
double coefficient(const BasisRow& row, const std::array<int, 3>& control) {
    double product = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int k = control[axis] - row.first[axis];
        product *= k >= 0 && k < 4 ? row.coefficient[axis][static_cast<std::size_t>(k)] : 0.0;
    }
    return product;
}

}  // namespace

double Constraint::control_gain() const {
    if (term_count == 1) {
        return pectin::control_gain(terms[0].row) * terms[0].row.length / length;
    }
    double largest = 0.0;
    for (std::size_t t = 0; t < term_count; ++t) {
        for (int flat = 0; flat < 64; ++flat) {
            const auto& first = terms[t].row.first;
            const std::array<int, 3> control{first[0] + flat % 4, first[1] + flat / 4 % 4,
                                             first[2] + flat / 16};
            double sum = 0.0;
            for (std::size_t u = 0; u < term_count; ++u) {
                sum += terms[u].factor * coefficient(terms[u].row, control);
            }
            largest = std::max(largest, std::abs(sum));
        }
    }
    return largest / length;  // NaN for a row of zeros
}

Constraint make_constraint(const Lattice& lattice, const std::optional<MirrorPlane>& plane,
                           const ConstraintKey& key) {
    Constraint constraint{.key = key};
    const auto add = [&](const Vec3& point, double factor) {
        const BasisRow row = row_at(lattice, point, key.along);
        if (!(row.length > 0.0)) return;
        constraint.terms[constraint.term_count++] = {row, factor * row.length};
    };
    // The derivative of b(Mx) along the normal of the plane has the opposite sign once more.
    const double sign = plane && key.along == plane->axis ? -key.parity : key.parity;
    if (!plane) {
        add(key.point, 1.0);
    } else if (plane->image(key.point) == key.point) {
        if (sign > 0.0) add(key.point, 2.0);
    } else {
        add(key.point, 1.0);
        add(plane->image(key.point), sign);
    }
    double squared = 0.0;
    const auto terms = std::span(constraint.terms).first(constraint.term_count);
    for (const auto& t : terms) {
        for (const auto& u : terms) {
            squared += &t == &u ? t.factor * t.factor : t.factor * u.factor * dot(t.row, u.row);
        }
    }
    if (!(squared > 0.0)) return {.key = key};
    constraint.length = terms.size() == 1 ? std::abs(terms[0].factor) : std::sqrt(squared);
    for (auto& term : terms) term.factor /= constraint.length;
    return constraint;
}

double dot(const Constraint& a, const Constraint& b) {
    if (a.key.parity != b.key.parity) return 0.0;
    double sum = 0.0;
    for (std::size_t t = 0; t < a.term_count; ++t) {
        for (std::size_t u = 0; u < b.term_count; ++u) {
            sum += a.terms[t].factor * b.terms[u].factor * dot(a.terms[t].row, b.terms[u].row);
        }
    }
    return sum;
}

}  // namespace pectin

#include "ffd/basis_row.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "ffd/cubic_basis.h"

namespace pectin {
namespace {

// along: the axis of differentiation, or −1 for none.
BasisRow row_of(const Lattice& lattice, const Vec3& x, int along) {
    assert(lattice.influences(x));
    const Vec3 u = lattice.parameter(x);
    BasisRow row{.length = 1.0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int at = static_cast<int>(axis);
        const BasisSpan span = basis_span(u[at]);
        row.first[axis] = span.first;
        double squared = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const int control = span.first + static_cast<int>(k);
            const bool moves = control >= 0 && control < lattice.deformable[at];
            const double basis =
                at == along ? span.derivative[k] / lattice.cell[at] : span.value[k];
            row.coefficient[axis][k] = moves ? basis : 0.0;
            squared += row.coefficient[axis][k] * row.coefficient[axis][k];
        }
        const double length = std::sqrt(squared);
        row.length *= length;
        if (!(length > 0.0)) return {};
        for (double& coefficient : row.coefficient[axis]) coefficient /= length;
    }
    return row;
}

}  // namespace

BasisRow basis_row(const Lattice& lattice, const Vec3& x) { return row_of(lattice, x, -1); }

BasisRow basis_derivative_row(const Lattice& lattice, const Vec3& x, int along) {
    return row_of(lattice, x, along);
}

double dot(const BasisRow& a, const BasisRow& b) {
    double product = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int shift = a.first[axis] - b.first[axis];
        double sum = 0.0;
        for (int k = std::max(0, -shift); k < std::min(4, 4 - shift); ++k) {
            sum += a.coefficient[axis][static_cast<std::size_t>(k)] *
                   b.coefficient[axis][static_cast<std::size_t>(k + shift)];
        }
        product *= sum;
    }
    return product;
}

double control_gain(const BasisRow& row) {
    double gain = 1.0;
    for (const auto& coefficients : row.coefficient) {
        gain *= *std::max_element(coefficients.begin(), coefficients.end());
    }
    return gain / row.length;
}

}  // namespace pectin

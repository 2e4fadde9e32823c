#include "ffd/weight_spline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "ffd/cubic_basis.h"

namespace pectin {

WeightSpline::WeightSpline(const Lattice& lattice, std::span<const double> coefficients)
    : lattice_(lattice) {
    assert(coefficients.size() == lattice.control_count());
    const IVec3 size = lattice.deformable + 2 * kPadding;
    row_ = static_cast<std::size_t>(size.x);
    layer_ = row_ * static_cast<std::size_t>(size.y);
    padded_.assign(layer_ * static_cast<std::size_t>(size.z), 0.0);
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                const IVec3 control{i, j, k};
                padded_[index(control)] = coefficients[lattice.control_index(control)];
            }
        }
    }
    find_bounds();
}

WeightSpline::Value WeightSpline::at(const Vec3& x) const {
    const Vec3 u = lattice_.parameter(x);
    const std::array<BasisSpan, 3> span{basis_span(u.x), basis_span(u.y), basis_span(u.z)};
    const double* const first = &padded_[index({span[0].first, span[1].first, span[2].first})];
    Value sum;
    for (std::size_t k = 0; k < 4; ++k) {
        double value = 0.0, along_x = 0.0, along_y = 0.0;
        for (std::size_t j = 0; j < 4; ++j) {
            const double* const c = first + k * layer_ + j * row_;
            const auto& b = span[0].value;
            const auto& d = span[0].derivative;
            const double row = b[0] * c[0] + b[1] * c[1] + b[2] * c[2] + b[3] * c[3];
            value += span[1].value[j] * row;
            along_y += span[1].derivative[j] * row;
            along_x += span[1].value[j] * (d[0] * c[0] + d[1] * c[1] + d[2] * c[2] + d[3] * c[3]);
        }
        sum.w += span[2].value[k] * value;
        sum.gradient += Vec3{span[2].value[k] * along_x, span[2].value[k] * along_y,
                             span[2].derivative[k] * value};
    }
    sum.gradient /= lattice_.cell;
    return sum;
}

void WeightSpline::find_bounds() {
    const std::array<std::size_t, 3> steps{1, row_, layer_};
    Vec3 slope{0.0};
    for (std::size_t at = 0; at < padded_.size(); ++at) {
        weight_bound_ = std::max(weight_bound_, std::abs(padded_[at]));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // The frame is zero, so that a step from its last layer to the first of the next row
            // adds no difference.
            if (at + steps[axis] >= padded_.size()) continue;
            double& largest = slope[static_cast<int>(axis)];
            largest = std::max(largest, std::abs(padded_[at + steps[axis]] - padded_[at]));
        }
    }
    gradient_bound_ = glm::length(slope / lattice_.cell);
}

}  // namespace pectin

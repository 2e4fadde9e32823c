#include "ffd/drag_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "ffd/cubic_basis.h"

namespace pectin {
namespace {

// How many weights are summed at a time, on the stack. The size of a batch changes no sum, and
// every batch evaluates all constraints once.
constexpr std::size_t kSmallBatch = 8, kLargeBatch = 256;

}  // namespace

DragField::DragField(const Lattice& lattice, std::vector<BasisRow> constraints,
                     std::vector<double> inverse)
    : lattice_(lattice),
      zone_(lattice.influenced_zone()),
      inverse_cell_(1.0 / lattice.cell),
      constraints_(std::move(constraints)),
      inverse_(std::move(inverse)) {
    assert(!constraints_.empty() && inverse_.size() % constraints_.size() == 0);
    weight_count_ = inverse_.size() / constraints_.size();
    products_.reserve(constraints_.size());
    for (const BasisRow& row : constraints_) {
        products_.push_back({axis_cubics(row, 0), axis_cubics(row, 1), axis_cubics(row, 2)});
    }
    bound_weights();
}

DragField::DragField(const Lattice& lattice, std::vector<WeightSpline> splines)
    : lattice_(lattice),
      zone_(lattice.influenced_zone()),
      inverse_cell_(1.0 / lattice.cell),
      weight_count_(splines.size()),
      splines_(std::move(splines)) {
    assert(!splines_.empty());
    for (const WeightSpline& spline : splines_) {
        bounds_.push_back({.weight = spline.weight_bound(), .gradient = spline.gradient_bound()});
    }
}

// A polynomial on [0, 1] lies between its least and greatest Bernstein coefficient. The
// coefficients of a cubic's derivative are three times the differences of the cubic's own.
DragField::Bound DragField::bound_of(const AxisCubics& cubics) {
    Bound bound;
    for (const auto& p : cubics.power) {
        const CubicCoefficients b = bernstein(p);
        for (std::size_t i = 0; i < 4; ++i) {
            bound.weight = std::max(bound.weight, std::abs(b[i]));
            if (i > 0) bound.gradient = std::max(bound.gradient, 3.0 * std::abs(b[i] - b[i - 1]));
        }
    }
    return bound;
}

void DragField::bound_weights() {
    bounds_.assign(weight_count_, {});
    for (std::size_t a = 0; a < products_.size(); ++a) {
        const Bound x = bound_of(products_[a][0]), y = bound_of(products_[a][1]),
                    z = bound_of(products_[a][2]);
        const Vec3 gradient =
            Vec3{x.gradient * y.weight * z.weight, x.weight * y.gradient * z.weight,
                 x.weight * y.weight * z.gradient} *
            inverse_cell_;
        for (std::size_t m = 0; m < weight_count_; ++m) {
            const double factor = std::abs(inverse_[m * products_.size() + a]);
            bounds_[m].weight += factor * x.weight * y.weight * z.weight;
            bounds_[m].gradient += factor * glm::length(gradient);
        }
    }
}

double DragField::reach_bound(std::span<const Vec3> displacements) const {
    assert(displacements.size() == weight_count_);
    double reach = 0.0;
    for (std::size_t m = 0; m < weight_count_; ++m) {
        reach += bounds_[m].weight * glm::length(displacements[m]);
    }
    return reach;
}

double DragField::lipschitz_bound(std::span<const Vec3> displacements) const {
    assert(displacements.size() == weight_count_);
    double bound = 1.0;
    for (std::size_t m = 0; m < weight_count_; ++m) {
        bound += bounds_[m].gradient * glm::length(displacements[m]);
    }
    return bound;
}

DragField::AxisCubics DragField::axis_cubics(const BasisRow& row, std::size_t axis) {
    AxisCubics cubics{.first_cell = row.first[axis] - 2};
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t piece = 0; piece < 4; ++piece) {
            for (std::size_t p = 0; p < 4; ++p) {
                cubics.power[k + piece][p] +=
                    row.coefficient[axis][k] * kPowerSegments[3 - piece][p];
            }
        }
    }
    return cubics;
}

// Parameters exceed −2, so truncation after a shift by the two influenced cells is a floor.
// Rounding may put a point one ulp into the neighbouring cell, whose cubic continues this one.
DragField::Location DragField::locate(const Vec3& x) const {
    const Vec3 u = lattice_.parameter(x);
    const IVec3 cell = IVec3{u + 2.0} - 2;
    return {.cell = cell, .inside = u - Vec3{cell}};
}

DragField::Value DragField::evaluate(const Product& product, const Location& at) {
    double f[3], df[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = static_cast<int>(axis);
        const auto piece = static_cast<unsigned>(at.cell[i] - product[axis].first_cell);
        if (piece >= product[axis].power.size()) return {};
        const auto& p = product[axis].power[piece];
        const double t = at.inside[i];
        f[axis] = ((p[3] * t + p[2]) * t + p[1]) * t + p[0];
        df[axis] = (3.0 * p[3] * t + 2.0 * p[2]) * t + p[1];
    }
    const double fg = f[0] * f[1];
    return {.value = fg * f[2],
            .derivative = {df[0] * f[1] * f[2], f[0] * df[1] * f[2], fg * df[2]}};
}

DragWeight DragField::rounded(const Value& sum) const {
    return {.w = static_cast<float>(sum.value), .gradient = Vec3f{sum.derivative * inverse_cell_}};
}

template <std::size_t batch>
void DragField::weights_in_batches(const Location& at, std::span<DragWeight> out) const {
    for (std::size_t first = 0; first < weight_count_; first += batch) {
        const std::size_t count = std::min(batch, weight_count_ - first);
        std::array<Value, batch> sums{};
        for (std::size_t a = 0; a < products_.size(); ++a) {
            const Value term = evaluate(products_[a], at);
            if (term.value == 0.0 && term.derivative == Vec3{0.0}) continue;  // does not reach x
            for (std::size_t m = 0; m < count; ++m) {
                const double factor = inverse_[(first + m) * products_.size() + a];
                sums[m].value += factor * term.value;
                sums[m].derivative += factor * term.derivative;
            }
        }
        for (std::size_t m = 0; m < count; ++m) out[first + m] = rounded(sums[m]);
    }
}

void DragField::weights_inside(const Location& at, std::span<DragWeight> out) const {
    if (weight_count_ <= kSmallBatch) {
        weights_in_batches<kSmallBatch>(at, out);
    } else {
        weights_in_batches<kLargeBatch>(at, out);
    }
}

void DragField::spline_weights(const Vec3& x, std::span<DragWeight> out) const {
    for (std::size_t m = 0; m < weight_count_; ++m) {
        const WeightSpline::Value value = splines_[m].at(x);
        out[m] = {.w = static_cast<float>(value.w), .gradient = Vec3f{value.gradient}};
    }
}

void DragField::weights(const Vec3& x, std::span<DragWeight> out) const {
    assert(out.size() == weight_count_);
    if (!zone_.contains_strictly(x)) {
        std::fill(out.begin(), out.end(), DragWeight{});
    } else if (!splines_.empty()) {
        spline_weights(x, out);
    } else if (products_.size() == 1 && weight_count_ == 1) {
        const Value term = evaluate(products_[0], locate(x));
        out[0] = rounded({inverse_[0] * term.value, inverse_[0] * term.derivative});
    } else {
        weights_inside(locate(x), out);
    }
}

void DragField::weights(std::span<const Vec3> points, std::span<DragWeight> out) const {
    assert(out.size() == points.size() * weight_count_);
    for (std::size_t p = 0; p < points.size(); ++p) {
        weights(points[p], out.subspan(p * weight_count_, weight_count_));
    }
}

void DragField::exact_weights(const Vec3& x, std::size_t first, std::span<ExactWeight> out) const {
    assert(first + out.size() <= weight_count_);
    std::fill(out.begin(), out.end(), ExactWeight{});
    if (!zone_.contains_strictly(x)) return;
    if (!splines_.empty()) {
        for (std::size_t m = 0; m < out.size(); ++m) {
            const WeightSpline::Value value = splines_[first + m].at(x);
            out[m] = {.w = value.w, .gradient = value.gradient};
        }
        return;
    }
    const Location at = locate(x);
    for (std::size_t a = 0; a < products_.size(); ++a) {
        const Value term = evaluate(products_[a], at);
        if (term.value == 0.0 && term.derivative == Vec3{0.0}) continue;
        for (std::size_t m = 0; m < out.size(); ++m) {
            const double factor = inverse_[(first + m) * products_.size() + a];
            out[m].w += factor * term.value;
            out[m].gradient += factor * term.derivative * inverse_cell_;
        }
    }
}

std::vector<Vec3> DragField::spline_displacements(std::span<const Vec3> displacements) const {
    std::vector<Vec3> controls;
    controls.reserve(lattice_.control_count());
    for (int k = 0; k < lattice_.deformable.z; ++k) {
        for (int j = 0; j < lattice_.deformable.y; ++j) {
            for (int i = 0; i < lattice_.deformable.x; ++i) {
                Vec3 sum{0.0};
                for (std::size_t m = 0; m < weight_count_; ++m) {
                    sum += splines_[m].coefficient({i, j, k}) * displacements[m];
                }
                controls.push_back(sum);
            }
        }
    }
    return controls;
}

std::vector<Vec3> DragField::control_displacements(std::span<const Vec3> displacements) const {
    assert(displacements.size() == weight_count_);
    if (!splines_.empty()) return spline_displacements(displacements);
    std::vector<Vec3> controls(lattice_.control_count(), Vec3{0.0});
    for (std::size_t a = 0; a < constraints_.size(); ++a) {
        Vec3 force{0.0};
        for (std::size_t m = 0; m < weight_count_; ++m) {
            force += inverse_[m * constraints_.size() + a] * displacements[m];
        }
        const auto& [first, coefficient, length] = constraints_[a];
        for (std::size_t flat = 0; flat < 64; ++flat) {
            const std::size_t i = flat % 4, j = flat / 4 % 4, k = flat / 16;
            const double b = coefficient[0][i] * coefficient[1][j] * coefficient[2][k];
            if (b == 0.0) continue;
            const IVec3 control =
                IVec3{first[0], first[1], first[2]} +
                IVec3{static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)};
            controls[lattice_.control_index(control)] += b * force;
        }
    }
    return controls;
}

}  // namespace pectin

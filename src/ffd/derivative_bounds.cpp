#include "ffd/derivative_bounds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "ffd/derivative_norms.h"

namespace pectin {

using derivative_norms::Cube;
using derivative_norms::Derivatives;
using derivative_norms::kRoundedUp;
using derivative_norms::squared;

namespace {

// Displacements whose cross product is below this fraction of their squared length are parallel.
constexpr double kParallel = 1e-13;
// The most fields, intervals of an axis and pieces of a region that are told apart.
constexpr std::size_t kMostFields = 2, kMostIntervals = 16, kMostPieces = 512;

constexpr CubicCoefficients derivative(const CubicCoefficients& p) {
    return {p[1], 2.0 * p[2], 3.0 * p[3], 0.0};
}

// Converts the four control values of a cell to the Bernstein coefficients of a derivative on the
// part [a, b] of that cell, raised to degree 3, as bernstein_conversion() does for the value.
CubicSegments conversion(int order, double a, double b) {
    const std::array<std::array<double, 3>, 4> arguments{
        {{a, a, a}, {a, a, b}, {a, b, b}, {b, b, b}}};
    CubicSegments result{};
    for (std::size_t k = 0; k < 4; ++k) {
        CubicCoefficients power = kPowerSegments[k];
        for (int i = 0; i < order; ++i) power = derivative(power);
        for (std::size_t i = 0; i < 4; ++i) {
            result[i][k] = blossom(power, arguments[i][0], arguments[i][1], arguments[i][2]);
        }
    }
    return result;
}

CubicSegments scaled(CubicSegments segments, double factor) {
    for (CubicCoefficients& row : segments) {
        for (double& value : row) value *= factor;
    }
    return segments;
}

// Applies a conversion along the axis whose indices are `step` apart.
template <std::size_t step, typename T>
Cube<T> converted(const Cube<T>& in, const CubicSegments& by) {
    Cube<T> out;
    for (std::size_t outer = 0; outer < 64; outer += 4 * step) {
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t inner = 0; inner < step; ++inner) {
                const std::size_t at = outer + inner;
                out[at + k * step] = by[k][0] * in[at] + by[k][1] * in[at + step] +
                                     by[k][2] * in[at + 2 * step] + by[k][3] * in[at + 3 * step];
            }
        }
    }
    return out;
}

template <typename T>
void add(Cube<T>& sum, const Cube<T>& more) {
    for (std::size_t i = 0; i < 64; ++i) sum[i] += more[i];
}

std::optional<Vec3> common_direction(std::span<const LatticeField> sum) {
    Vec3 longest{0.0};
    for (const LatticeField& field : sum) {
        for (const Vec3& d : field.displacements()) {
            if (squared(d) > squared(longest)) longest = d;
        }
    }
    const double most = kParallel * squared(longest);
    for (const LatticeField& field : sum) {
        for (const Vec3& d : field.displacements()) {
            if (glm::length(glm::cross(d, longest)) > most) return std::nullopt;
        }
    }
    return unit_or_zero(longest);
}

}  // namespace

// A part of an axis without a knot inside, and what each lattice contributes there. Not
// initialised, since there is room for many of them and most regions need few.
struct DerivativeBounds::Interval {
    struct Contribution {
        bool is_inside;
        int first;                            // control point
        std::array<CubicSegments, 3> orders;  // of the value and its two derivatives
    };
    double start, end;
    std::array<Contribution, kMostFields> contributions;
};

struct DerivativeBounds::Pieces {
    std::array<std::array<Interval, kMostIntervals>, 3> intervals;
    std::array<std::size_t, 3> counts;
};

template <>
const std::vector<double>& DerivativeBounds::values_of(const Field& field) const {
    return field.along;
}
template <>
const std::vector<Vec3>& DerivativeBounds::values_of(const Field& field) const {
    return field.points;
}

DerivativeBounds::DerivativeBounds(std::span<const LatticeField> sum)
    : direction_(common_direction(sum)) {
    assert(sum.size() <= kMostFields);
    for (const LatticeField& field : sum) {
        if (direction_) {
            add_field<double>(field);
        } else {
            add_field<Vec3>(field);
        }
        double farthest = 0.0;
        Box displacements;
        displacements.include(Vec3{0.0});
        for (const Vec3& d : field.displacements()) {
            farthest = std::max(farthest, squared(d));
            displacements.include(d);
        }
        reach_ += std::sqrt(farthest);
        range_ += displacements.diagonal() * kRoundedUp;
    }
}

template <typename T>
void DerivativeBounds::add_field(const LatticeField& from) {
    const Lattice& lattice = from.lattice();
    const auto size = [&](int axis) {
        return static_cast<std::size_t>(lattice.deformable[axis] + 6);
    };
    Field& field = fields_.emplace_back();
    field.lattice = lattice;
    field.steps = {1, size(0), size(0) * size(1)};
    auto& values = const_cast<std::vector<T>&>(values_of<T>(field));
    values.assign(field.steps[2] * size(2), T{0.0});
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                const Vec3& d = from.displacements()[lattice.control_index({i, j, k})];
                T& value = values[static_cast<std::size_t>(i + 3) * field.steps[0] +
                                  static_cast<std::size_t>(j + 3) * field.steps[1] +
                                  static_cast<std::size_t>(k + 3) * field.steps[2]];
                if constexpr (std::is_same_v<T, double>) {
                    value = glm::dot(d, *direction_);
                } else {
                    value = d;
                }
            }
        }
    }
    const Everywhere bounds = everywhere<T>(field);
    everywhere_.gradient += bounds.gradient;
    everywhere_.second += bounds.second;
}

// Derivatives are splines of a lower degree, whose coefficients are the differences of neighbouring
// control points. The frame is static, so that a difference across the end of a row adds nothing.
template <typename T>
DerivativeBounds::Everywhere DerivativeBounds::everywhere(const Field& field) const {
    const std::vector<T>& values = values_of<T>(field);
    double first = 0.0, second = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
        const double cell_a = field.lattice.cell[static_cast<int>(a)];
        double slope = 0.0;
        for (std::size_t i = field.steps[a]; i < values.size(); ++i) {
            slope = std::max(slope, squared((values[i] - values[i - field.steps[a]]) / cell_a));
        }
        first += slope;
        for (std::size_t b = 0; b < 3; ++b) {
            const double cell_b = field.lattice.cell[static_cast<int>(b)];
            const std::size_t p = field.steps[a], q = field.steps[b];
            double bend = 0.0;
            for (std::size_t i = p + q; i < values.size(); ++i) {
                const T difference = values[i] - values[i - p] - values[i - q] + values[i - p - q];
                bend = std::max(bend, squared(difference / cell_a / cell_b));
            }
            second += bend;
        }
    }
    return {std::sqrt(first), std::sqrt(second)};
}

// Divides the box of a region at all knots. False if there are too many pieces.
bool DerivativeBounds::divide(const Region& region, Pieces& pieces) const {
    std::size_t total = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto& [a, b, c] = region.corners;
        const double low = std::min({a[axis], b[axis], c[axis]}) - region.margin,
                     high = std::max({a[axis], b[axis], c[axis]}) + region.margin;
        std::array<double, kMostIntervals + 1> ends;
        std::size_t count = 0;
        ends[count++] = low;
        for (const Field& field : fields_) {
            const Lattice& lattice = field.lattice;
            const double origin = lattice.origin[axis], cell = lattice.cell[axis];
            const double first = std::max(-2.0, std::floor((low - origin) / cell)),
                         last = std::min(lattice.deformable[axis] + 1.0,
                                         std::ceil((high - origin) / cell));
            for (double knot = first; knot <= last; ++knot) {
                const double at = origin + knot * cell;
                if (!(at > low && at < high)) continue;
                if (count == kMostIntervals) return false;
                ends[count++] = at;
            }
        }
        ends[count++] = high;
        std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count));
        const auto axis_index = static_cast<std::size_t>(axis);
        pieces.counts[axis_index] = count - 1;
        total *= count - 1;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            Interval& interval = pieces.intervals[axis_index][i];
            interval.start = ends[i];
            interval.end = ends[i + 1];
            const double middle = 0.5 * (ends[i] + ends[i + 1]);
            for (std::size_t f = 0; f < fields_.size(); ++f) {
                const Lattice& lattice = fields_[f].lattice;
                const double origin = lattice.origin[axis], width = lattice.cell[axis];
                const double cell = std::floor((middle - origin) / width);
                Interval::Contribution& part = interval.contributions[f];
                part.is_inside = cell >= -2.0 && cell <= lattice.deformable[axis];
                if (!part.is_inside) continue;
                part.first = static_cast<int>(cell) - 1;
                const double from = (ends[i] - origin) / width - cell,
                             to = (ends[i + 1] - origin) / width - cell;
                part.orders = {conversion(0, from, to),
                               scaled(conversion(1, from, to), 1.0 / width),
                               scaled(conversion(2, from, to), 1.0 / (width * width))};
            }
        }
    }
    return total <= kMostPieces;
}

// The 64 control values that reach a piece. False if all are zero.
template <typename T>
bool DerivativeBounds::gather(const Pieces& pieces, const std::array<std::size_t, 3>& piece,
                              std::size_t field, Cube<T>& values) const {
    const Field& from = fields_[field];
    std::size_t first = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& part = pieces.intervals[axis][piece[axis]].contributions[field];
        if (!part.is_inside) return false;
        first += from.steps[axis] * static_cast<std::size_t>(part.first + 3);
    }
    const T* const source = values_of<T>(from).data() + first;
    bool any = false;
    for (std::size_t i = 0; i < 64; ++i) {
        values[i] = source[i % 4 + i / 4 % 4 * from.steps[1] + i / 16 * from.steps[2]];
        any = any || values[i] != T{0.0};
    }
    return any;
}

// Calls measure(derivatives) for each piece that meets the region, or still() if nothing moves
// there.
template <typename T, typename Measure, typename Still>
void DerivativeBounds::for_each_piece(const Region& region, const Pieces& pieces,
                                      const Measure& measure, const Still& still) const {
    const auto& [nx, ny, nz] = pieces.counts;
    const bool is_whole = nx * ny * nz <= 2;
    Derivatives<T> sum;
    Cube<T> values;
    for (std::size_t at = 0; at < nx * ny * nz; ++at) {
        const std::array<std::size_t, 3> piece{at % nx, at / nx % ny, at / nx / ny};
        const Interval &x = pieces.intervals[0][piece[0]], &y = pieces.intervals[1][piece[1]],
                       &z = pieces.intervals[2][piece[2]];
        const Box box{.min = Vec3{x.start, y.start, z.start} - region.margin,
                      .max = Vec3{x.end, y.end, z.end} + region.margin};
        const auto& [a, b, c] = region.corners;
        if (!is_whole && !triangle_meets_box(a, b, c, box)) continue;
        bool moves = false;
        for (std::size_t f = 0; f < fields_.size(); ++f) {
            if (!gather(pieces, piece, f, values)) continue;
            const auto &i = x.contributions[f].orders, &j = y.contributions[f].orders,
                       &k = z.contributions[f].orders;
            const Cube<T> x0 = converted<1>(values, i[0]), x1 = converted<1>(values, i[1]),
                          x2 = converted<1>(values, i[2]);
            const Cube<T> x0y0 = converted<4>(x0, j[0]), x1y0 = converted<4>(x1, j[0]),
                          x0y1 = converted<4>(x0, j[1]);
            const std::array<Cube<T>, 3> first{converted<16>(x1y0, k[0]), converted<16>(x0y1, k[0]),
                                               converted<16>(x0y0, k[1])};
            const std::array<Cube<T>, 6> second{converted<16>(converted<4>(x2, j[0]), k[0]),
                                                converted<16>(converted<4>(x0, j[2]), k[0]),
                                                converted<16>(x0y0, k[2]),
                                                converted<16>(converted<4>(x1, j[1]), k[0]),
                                                converted<16>(x0y1, k[1]),
                                                converted<16>(x1y0, k[1])};
            for (std::size_t e = 0; e < 3; ++e) {
                if (moves)
                    add(sum.first[e], first[e]);
                else
                    sum.first[e] = first[e];
            }
            for (std::size_t e = 0; e < 6; ++e) {
                if (moves)
                    add(sum.second[e], second[e]);
                else
                    sum.second[e] = second[e];
            }
            moves = true;
        }
        if (moves)
            measure(sum);
        else
            still();
    }
}

template <typename T>
DerivativeBounds::Bound DerivativeBounds::bound_over(const Region& region, const Pieces& pieces,
                                                     const Vec3& p, const Vec3& q,
                                                     bool only_bend) const {
    Bound bound;
    PlaneBendBound<T> bend(p, q);
    const Vec3 direction = direction_.value_or(Vec3{0.0});
    for_each_piece<T>(
        region, pieces,
        [&](const Derivatives<T>& of) {
            bend.add(of.second);
            if (only_bend) return;
            bound.bend_any =
                std::max(bound.bend_any, derivative_norms::squared_bend_any(of.second));
            bound.stretch =
                std::max(bound.stretch, derivative_norms::stretch_over(of.first, direction));
        },
        [] {});
    bound.bend = bend.bound();
    bound.bend_any = std::sqrt(bound.bend_any) * kRoundedUp;
    return bound;
}

DerivativeBounds::Bound DerivativeBounds::bound(const Region& region, const Vec3& p, const Vec3& q,
                                                bool only_bend) const {
    Pieces pieces;
    if (!divide(region, pieces)) {
        const double most =
            everywhere_.second * derivative_norms::squared_radius(p, q) * kRoundedUp;
        return {.stretch = (1.0 + everywhere_.gradient) * kRoundedUp,
                .bend = {most, PlaneForm::circular(most)},
                .bend_any = everywhere_.second * kRoundedUp};
    }
    return direction_ ? bound_over<double>(region, pieces, p, q, only_bend)
                      : bound_over<Vec3>(region, pieces, p, q, only_bend);
}

DerivativeBounds::Bound DerivativeBounds::over(const Region& region, const Vec3& p,
                                               const Vec3& q) const {
    return bound(region, p, q, false);
}

template <typename T>
void DerivativeBounds::transport_over(const Region& region, Pieces& pieces,
                                      const std::array<T, 3>& from, const Mat3& s,
                                      Transport& result) const {
    double bend = 0.0, deviation = 0.0;
    const auto reach_out = [&](const Derivatives<T>& of) {
        bend = std::max(bend, derivative_norms::squared_bend_within(of.second, s));
        result.stretch = std::max(result.stretch, derivative_norms::stretch_over(
                                                      of.first, direction_.value_or(Vec3{0.0})));
    };
    for_each_piece<T>(region, pieces, reach_out, [] {});
    const auto deviate = [&](const std::array<Cube<T>, 3>& first) {
        deviation = std::max(deviation, derivative_norms::squared_variation(first, from, s));
    };
    const Region triangle{region.corners, 0.0};
    divide(triangle, pieces);
    for_each_piece<T>(
        triangle, pieces, [&](const Derivatives<T>& of) { deviate(of.first); },
        [&] { deviate(std::array<Cube<T>, 3>{}); });
    result.rest = (std::sqrt(deviation) + 0.5 * std::sqrt(bend)) * kRoundedUp;
}

DerivativeBounds::Transport DerivativeBounds::transport(const Region& region, const Mat3& at_centre,
                                                        const Mat3& s) const {
    Transport result;
    const Mat3 g = at_centre - Mat3{1.0};
    Pieces pieces;
    if (!divide(region, pieces)) {
        result.stretch = (1.0 + everywhere_.gradient) * kRoundedUp;
        result.rest = everywhere_.gradient * std::sqrt(s[0][0] + s[1][1] + s[2][2]) * kRoundedUp;
    } else if (direction_) {
        const Vec3 slope = *direction_ * g;
        result.jacobian += glm::outerProduct(*direction_, slope);
        transport_over<double>(region, pieces, {slope.x, slope.y, slope.z}, s, result);
    } else {
        result.jacobian = at_centre;
        transport_over<Vec3>(region, pieces, {g[0], g[1], g[2]}, s, result);
    }
    return result;
}

PlaneBend DerivativeBounds::bend(const Region& region, const Vec3& p, const Vec3& q) const {
    return bound(region, p, q, true).bend;
}

}  // namespace pectin

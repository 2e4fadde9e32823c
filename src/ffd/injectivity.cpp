#include "ffd/injectivity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace pectin {
namespace {

// Knots of two lattices nearer than this share of a cell are one: across it two cubics that meet
// with two continuous derivatives differ by its third power.
constexpr double kSameKnot = 1e-9;
// Displacements whose cross product is below this share of their squared length are parallel.
constexpr double kParallel = 1e-12;
// Displacements of this many cells are not looked at: their squares and determinants would leave
// the range of numbers.
constexpr double kSteepest = 1e90;
// What rounding may take from a cheap bound, as a share of it: it then passes over no box that the
// coefficients themselves would lower the limit by.
constexpr double kRounding = 1e-9;
// Halvings of an interval of t: to the last digit.
constexpr int kBisections = 52;

// The four cubics that control points first … first + 3 contribute in a cell, in powers of t.
constexpr std::array<std::array<double, 4>, 4> kPieces{{{1.0 / 6.0, -0.5, 0.5, -1.0 / 6.0},
                                                        {4.0 / 6.0, 0.0, -1.0, 0.5},
                                                        {1.0 / 6.0, 0.5, 0.5, -0.5},
                                                        {0.0, 0.0, 0.0, 1.0 / 6.0}}};

// From four control values to the Bernstein coefficients on a part of their cell.
using Conversion = std::array<std::array<double, 4>, 4>;  // [coefficient][control]

// Coefficient k on [a, b] is the blossom (polar form) at 3 − k times a and k times b.
Conversion conversion(double a, double b) {
    const std::array<std::array<double, 3>, 4> arguments{
        {{a, a, a}, {a, a, b}, {a, b, b}, {b, b, b}}};
    Conversion result;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& [r, s, t] = arguments[k];
        for (std::size_t control = 0; control < 4; ++control) {
            const auto& p = kPieces[control];
            result[k][control] = p[0] + p[1] * (r + s + t) / 3.0 +
                                 p[2] * (r * s + s * t + t * r) / 3.0 + p[3] * r * s * t;
        }
    }
    return result;
}

// An interval of one axis between two knots, and what each lattice has there.
struct Interval {
    struct Contribution {
        bool is_inside = false;
        int first = 0;  // control point
        Conversion conversion{};
    };
    double start = 0.0, width = 0.0;
    std::vector<Contribution> contributions;  // one a field
};

std::vector<double> knots(std::span<const LatticeField> sum, int axis, int parts) {
    std::vector<double> all;
    double smallest = sum.front().lattice().cell[axis];
    for (const LatticeField& field : sum) {
        const Lattice& lattice = field.lattice();
        smallest = std::min(smallest, lattice.cell[axis]);
        for (int i = -2; i <= lattice.deformable[axis] + 1; ++i) {
            all.push_back(lattice.origin[axis] + i * lattice.cell[axis]);
        }
    }
    std::sort(all.begin(), all.end());
    const double tolerance = kSameKnot * smallest;
    all.erase(
        std::unique(all.begin(), all.end(), [&](double x, double y) { return y - x < tolerance; }),
        all.end());
    std::vector<double> divided;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        for (int part = 0; part < parts; ++part) {
            divided.push_back(all[i] + (all[i + 1] - all[i]) * part / parts);
        }
    }
    divided.push_back(all.back());
    return divided;
}

std::vector<Interval> intervals(std::span<const LatticeField> sum, int axis, int parts) {
    const std::vector<double> ends = knots(sum, axis, parts);
    std::vector<Interval> result;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        Interval interval{.start = ends[i], .width = ends[i + 1] - ends[i], .contributions = {}};
        for (const LatticeField& field : sum) {
            const Lattice& lattice = field.lattice();
            const double middle = 0.5 * (ends[i] + ends[i + 1]);
            const double cell = std::floor((middle - lattice.origin[axis]) / lattice.cell[axis]);
            const double knot = lattice.origin[axis] + cell * lattice.cell[axis];
            const bool is_inside = cell >= -2.0 && cell <= lattice.deformable[axis];
            interval.contributions.push_back(
                {.is_inside = is_inside,
                 .first = is_inside ? static_cast<int>(cell) - 1 : 0,  // else beyond any int
                 .conversion = conversion((ends[i] - knot) / lattice.cell[axis],
                                          (ends[i + 1] - knot) / lattice.cell[axis])});
        }
        result.push_back(std::move(interval));
    }
    return result;
}

// The displacement on one box as 64 Bernstein coefficients, i fastest: a vector, or how far it goes
// along the one direction it has.
template <typename T>
struct Coefficients {
    std::array<T, 64> of{};
    Vec3 width{1.0};

    // ∂D/∂(an axis), its degree raised to 3 again: steps is 1, 4 or 16, position i, j or k.
    T slope(int flat, int position, int steps, double extent) const {
        const auto value = [&](int p) {
            return of[static_cast<std::size_t>(flat + (p - position) * steps)];
        };
        switch (position) {
            case 0:
                return 3.0 / extent * (value(1) - value(0));
            case 1:
                return 1.0 / extent * (value(1) - value(0) + 2.0 * (value(2) - value(1)));
            case 2:
                return 1.0 / extent * (2.0 * (value(2) - value(1)) + value(3) - value(2));
            default:
                return 3.0 / extent * (value(3) - value(2));
        }
    }
    // Of the differences of neighbours along the axis, each times 3/extent, the one of which
    // measure(difference) is largest; the axis' slopes are means of them. Sixteen lines at once,
    // none of which waits for another.
    template <typename Measure>
    double largest_slope(int axis, const Measure& measure) const {
        const std::size_t steps = axis == 0 ? 1 : axis == 1 ? 4 : 16;
        const double factor = 3.0 / width[axis];
        std::array<double, 16> largest;
        largest.fill(-std::numeric_limits<double>::infinity());
        for (std::size_t p = 0; p < 3; ++p) {
            for (std::size_t line = 0; line < 16; ++line) {
                const std::size_t at = line % steps + line / steps * steps * 4 + p * steps;
                const double value = measure(factor * (of[at + steps] - of[at]));
                largest[line] = largest[line] < value ? value : largest[line];
            }
        }
        return *std::max_element(largest.begin(), largest.end());
    }
    std::array<T, 3> gradient(int flat) const {
        return {slope(flat, flat % 4, 1, width.x), slope(flat, flat / 4 % 4, 4, width.y),
                slope(flat, flat / 16, 16, width.z)};
    }
};

// Applies a conversion along the axis whose indices are `steps` apart.
template <typename T>
void convert(std::array<T, 64>& values, const Conversion& by, std::size_t steps) {
    for (std::size_t line = 0; line < 16; ++line) {
        const std::size_t base = line % steps + line / steps * steps * 4;
        const std::array<T, 4> before{values[base], values[base + steps], values[base + 2 * steps],
                                      values[base + 3 * steps]};
        for (std::size_t k = 0; k < 4; ++k) {
            values[base + k * steps] = by[k][0] * before[0] + by[k][1] * before[1] +
                                       by[k][2] * before[2] + by[k][3] * before[3];
        }
    }
}

// Space cut at all knots of all lattices, each piece further into parts³ boxes.
class BernsteinGrid {
  public:
    BernsteinGrid(std::span<const LatticeField> sum, int parts)
        : sum_(sum),
          axes_{intervals(sum, 0, parts), intervals(sum, 1, parts), intervals(sum, 2, parts)} {}

    IVec3 counts() const {
        return {static_cast<int>(axes_[0].size()), static_cast<int>(axes_[1].size()),
                static_cast<int>(axes_[2].size())};
    }
    Box box(const IVec3& index) const {
        const Interval &x = interval(0, index), &y = interval(1, index), &z = interval(2, index);
        const Vec3 start{x.start, y.start, z.start};
        return {.min = start, .max = start + Vec3{x.width, y.width, z.width}};
    }
    // Whether anything moves in the box; its coefficients then.
    // part(d): what of a control point's displacement is looked at.
    template <typename T, typename Part>
    bool coefficients(const IVec3& box, const Part& part, Coefficients<T>& out) const {
        const std::array<const Interval*, 3> sides{&interval(0, box), &interval(1, box),
                                                   &interval(2, box)};
        out.width = {sides[0]->width, sides[1]->width, sides[2]->width};
        bool moves = false;
        for (std::size_t f = 0; f < sum_.size(); ++f) {
            std::array<T, 64> values;
            if (!gather(sum_[f], f, sides, part, values)) continue;
            convert(values, sides[0]->contributions[f].conversion, 1);
            convert(values, sides[1]->contributions[f].conversion, 4);
            convert(values, sides[2]->contributions[f].conversion, 16);
            for (std::size_t i = 0; i < 64; ++i) {
                out.of[i] = moves ? out.of[i] + values[i] : values[i];
            }
            moves = true;
        }
        return moves;
    }

  private:
    const Interval& interval(std::size_t axis, const IVec3& box) const {
        return axes_[axis][static_cast<std::size_t>(box[static_cast<int>(axis)])];
    }
    // The 4 × 4 × 4 control displacements that reach the box; whether any is not zero.
    template <typename T, typename Part>
    static bool gather(const LatticeField& field, std::size_t f,
                       const std::array<const Interval*, 3>& sides, const Part& part,
                       std::array<T, 64>& out) {
        const Lattice& lattice = field.lattice();
        const IVec3 first{sides[0]->contributions[f].first, sides[1]->contributions[f].first,
                          sides[2]->contributions[f].first};
        for (const Interval* side : sides) {
            if (!side->contributions[f].is_inside) return false;
        }
        bool any = false;
        for (int flat = 0; flat < 64; ++flat) {
            const IVec3 control = first + IVec3{flat % 4, flat / 4 % 4, flat / 16};
            const bool is_deformable = glm::all(glm::greaterThanEqual(control, IVec3{0})) &&
                                       glm::all(glm::lessThan(control, lattice.deformable));
            T& d = out[static_cast<std::size_t>(flat)];
            d = is_deformable ? part(field.displacements()[lattice.control_index(control)])
                              : T{0.0};
            any = any || d != T{0.0};
        }
        return any;
    }

    std::span<const LatticeField> sum_;
    std::array<std::vector<Interval>, 3> axes_;
};

template <typename Visit>
void for_each_box(const IVec3& from, const IVec3& to, const Visit& visit) {
    for (int k = from.z; k < to.z; ++k) {
        for (int j = from.y; j < to.y; ++j) {
            for (int i = from.x; i < to.x; ++i) visit(IVec3{i, j, k});
        }
    }
}

bool is_within_numbers(const LatticeField& field) {
    const double most = kSteepest * field.lattice().smallest_cell_extent();
    return std::all_of(
        field.displacements().begin(), field.displacements().end(), [&](const Vec3& d) {
            return std::abs(d.x) <= most && std::abs(d.y) <= most && std::abs(d.z) <= most;
        });
}

// The unit vector along which all displacements lie, if there is one.
std::optional<Vec3> common_direction(std::span<const LatticeField> sum) {
    Vec3 longest{0.0};
    for (const LatticeField& field : sum) {
        for (const Vec3& d : field.displacements()) {
            if (glm::dot(d, d) > glm::dot(longest, longest)) longest = d;
        }
    }
    const double most = kParallel * glm::dot(longest, longest);
    for (const LatticeField& field : sum) {
        for (const Vec3& d : field.displacements()) {
            if (glm::length(glm::cross(d, longest)) > most) return std::nullopt;
        }
    }
    return unit_or_zero(longest);
}

bool is_positive_definite(const Mat3& m) {
    return m[0][0] > 0.0 && m[0][0] * m[1][1] > m[1][0] * m[1][0] && glm::determinant(m) > 0.0;
}

// At least the squared Frobenius norm of every gradient coefficient.
double squared_norm_bound(const Coefficients<Vec3>& coefficients) {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        sum +=
            coefficients.largest_slope(axis, [](const Vec3& slope) { return dot(slope, slope); });
    }
    return sum;
}

// What one coefficient of the gradient allows where all displacements lie along one direction.
struct DivergenceLimit {
    Vec3 direction;

    double part(const Vec3& d) const { return glm::dot(d, direction); }
    // The largest t ≤ most for which it keeps det J positive enough.
    double operator()(const std::array<double, 3>& gradient, double most) const {
        const double divergence = glm::dot(Vec3{gradient[0], gradient[1], gradient[2]}, direction);
        return 1.0 - kLeastStretch + most * divergence >= 0.0 ? most
                                                              : (1.0 - kLeastStretch) / -divergence;
    }
    // Whether all coefficients allow `most`, by the steepest descent along each axis.
    bool surely_allows(const Coefficients<double>& coefficients, double most) const {
        double descent = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            descent += coefficients.largest_slope(
                axis, [&](double slope) { return -slope * direction[axis]; });
        }
        return most * descent <= (1.0 - kLeastStretch) * (1.0 - kRounding);
    }
};

// The same in general, by the symmetric part of J.
struct SymmetricPartLimit {
    static Vec3 part(const Vec3& d) { return d; }
    double operator()(const std::array<Vec3, 3>& gradient, double most) const {
        const Mat3 g{gradient[0], gradient[1], gradient[2]};
        const Mat3 symmetric = 0.5 * (g + glm::transpose(g));
        const auto allows = [&](double t) {
            return is_positive_definite(Mat3{1.0 - kLeastStretch} + t * symmetric);
        };
        if (allows(most)) return most;
        double low = 0.0, high = most;
        for (int i = 0; i < kBisections; ++i) {
            const double middle = 0.5 * (low + high);
            (allows(middle) ? low : high) = middle;
        }
        return low;
    }
    // By the steepest slopes: no eigenvalue is beyond the Frobenius norm.
    bool surely_allows(const Coefficients<Vec3>& coefficients, double most) const {
        return most * std::sqrt(squared_norm_bound(coefficients)) <=
               (1.0 - kLeastStretch) * (1.0 - kRounding);
    }
};

// The largest t ≤ most that one box allows, by all of its coefficients.
template <typename T, typename Limit>
double limit_of(const Coefficients<T>& coefficients, double most, const Limit& limit) {
    if (limit.surely_allows(coefficients, most)) return most;
    for (int flat = 0; flat < 64; ++flat) most = limit(coefficients.gradient(flat), most);
    return most;
}

// Boxes that allow less than all so far are halved.
template <typename T, typename Limit>
double limit_over_boxes(std::span<const LatticeField> sum, double most, const Limit& limit) {
    const BernsteinGrid whole(sum, 1);
    std::optional<BernsteinGrid> halved;
    const auto part = [&](const Vec3& d) { return limit.part(d); };
    Coefficients<T> coefficients;
    double fraction = most;
    for_each_box(IVec3{0}, whole.counts(), [&](const IVec3& box) {
        if (!whole.coefficients(box, part, coefficients)) return;
        if (limit_of(coefficients, fraction, limit) == fraction) return;
        if (!halved) halved.emplace(sum, 2);
        for_each_box(2 * box, 2 * box + 2, [&](const IVec3& eighth) {
            if (halved->coefficients(eighth, part, coefficients)) {
                fraction = limit_of(coefficients, fraction, limit);
            }
        });
    });
    return fraction;
}

template <typename T, typename Limit>
std::vector<BoxLimit> limits_of_boxes(std::span<const LatticeField> sum, double most,
                                      const Limit& limit) {
    const BernsteinGrid halved(sum, 2);
    const auto part = [&](const Vec3& d) { return limit.part(d); };
    std::vector<BoxLimit> limits;
    Coefficients<T> coefficients;
    for_each_box(IVec3{0}, halved.counts(), [&](const IVec3& box) {
        if (!halved.coefficients(box, part, coefficients)) return;
        limits.push_back({halved.box(box), limit_of(coefficients, most, limit)});
    });
    return limits;
}

}  // namespace

double injective_limit(std::span<const LatticeField> sum, double most) {
    assert(!sum.empty());
    if (!std::all_of(sum.begin(), sum.end(), is_within_numbers)) return 0.0;
    if (const auto direction = common_direction(sum)) {
        return limit_over_boxes<double>(sum, most, DivergenceLimit{*direction});
    }
    return limit_over_boxes<Vec3>(sum, most, SymmetricPartLimit{});
}

std::vector<BoxLimit> injective_limits_of_boxes(std::span<const LatticeField> sum, double most) {
    if (const auto direction = common_direction(sum)) {
        return limits_of_boxes<double>(sum, most, DivergenceLimit{*direction});
    }
    return limits_of_boxes<Vec3>(sum, most, SymmetricPartLimit{});
}

double gradient_bound(std::span<const LatticeField> sum) {
    const BernsteinGrid whole(sum, 1), halved(sum, 2);
    const auto all = [](const Vec3& d) { return d; };
    Coefficients<Vec3> coefficients;
    const auto largest_norm = [&] {
        double largest = 0.0;
        for (int flat = 0; flat < 64; ++flat) {
            const auto g = coefficients.gradient(flat);
            largest = std::max(largest,
                               glm::dot(g[0], g[0]) + glm::dot(g[1], g[1]) + glm::dot(g[2], g[2]));
        }
        return largest;
    };
    double largest = 0.0;
    for_each_box(IVec3{0}, whole.counts(), [&](const IVec3& box) {
        if (!whole.coefficients(box, all, coefficients)) return;
        if (squared_norm_bound(coefficients) <= largest || largest_norm() <= largest) return;
        for_each_box(2 * box, 2 * box + 2, [&](const IVec3& eighth) {
            if (halved.coefficients(eighth, all, coefficients)) {
                largest = std::max(largest, largest_norm());
            }
        });
    });
    return std::sqrt(largest);
}

}  // namespace pectin

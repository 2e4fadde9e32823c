#include "ffd/injectivity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

#include "ffd/bernstein_grid.h"

namespace pectin {
namespace {

// Displacements whose cross product is below this fraction of their squared length are parallel.
constexpr double kParallel = 1e-12;
// Nothing is proven for displacements of more cells than this, since their squares and determinants
// would leave the range of double.
constexpr double kSteepest = 1e90;
// The relative rounding error that a cheap bound allows for. Without it the bound might skip a box
// whose coefficients would lower the limit.
constexpr double kRounding = 1e-9;
// Halvings of an interval of t, which determine t to its last digit.
constexpr int kBisections = 52;

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

// The unit vector to which all displacements are parallel, if there is one.
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

// An upper bound of the squared Frobenius norms of all gradient coefficients.
double squared_norm_bound(const BernsteinCoefficients<Vec3>& coefficients) {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        sum +=
            coefficients.largest_slope(axis, [](const Vec3& slope) { return dot(slope, slope); });
    }
    return sum;
}

// The limit on t where all displacements are parallel to one direction, from det J.
struct DivergenceLimit {
    Vec3 direction;

    double part(const Vec3& d) const { return glm::dot(d, direction); }
    // The largest t ≤ most for which this gradient coefficient keeps det J ≥ kLeastStretch.
    double operator()(const std::array<double, 3>& gradient, double most) const {
        const double divergence = glm::dot(Vec3{gradient[0], gradient[1], gradient[2]}, direction);
        return 1.0 - kLeastStretch + most * divergence >= 0.0 ? most
                                                              : (1.0 - kLeastStretch) / -divergence;
    }
    // A fast test by the steepest descent along each axis. True means that all coefficients allow
    // `most`; false is inconclusive.
    bool surely_allows(const BernsteinCoefficients<double>& coefficients, double most) const {
        double descent = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            descent += coefficients.largest_slope(
                axis, [&](double slope) { return -slope * direction[axis]; });
        }
        return most * descent <= (1.0 - kLeastStretch) * (1.0 - kRounding);
    }
};

// The limit on t in general, from the symmetric part of J.
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
    // The same fast test by the steepest slopes: no eigenvalue exceeds the Frobenius norm.
    bool surely_allows(const BernsteinCoefficients<Vec3>& coefficients, double most) const {
        return most * std::sqrt(squared_norm_bound(coefficients)) <=
               (1.0 - kLeastStretch) * (1.0 - kRounding);
    }
};

// The largest t ≤ most that all coefficients of one box allow.
template <typename T, typename Limit>
double limit_of(const BernsteinCoefficients<T>& coefficients, double most, const Limit& limit) {
    if (limit.surely_allows(coefficients, most)) return most;
    for (int flat = 0; flat < 64; ++flat) most = limit(coefficients.gradient(flat), most);
    return most;
}

// The largest t ≤ most that all boxes allow. A box that would lower the limit is halved along each
// axis, and its eight parts are tried instead.
template <typename T, typename Limit>
double limit_over_boxes(std::span<const LatticeField> sum, double most, const Limit& limit) {
    const BernsteinGrid whole(sum, 1);
    std::optional<BernsteinGrid> halved;
    const auto part = [&](const Vec3& d) { return limit.part(d); };
    BernsteinCoefficients<T> coefficients;
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
    BernsteinCoefficients<T> coefficients;
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
    BernsteinCoefficients<Vec3> coefficients;
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

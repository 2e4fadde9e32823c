// The sum of several lattices' displacements in Bernstein form, box by box.
// Source: G. Farin. Curves and Surfaces for CAGD. Morgan Kaufmann 2002 (Bernstein form, blossoms).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "ffd/cubic_basis.h"
#include "ffd/lattice_field.h"
#include "geometry/box.h"

namespace pectin {

// The displacement on one box as 64 Bernstein coefficients, i fastest. T is Vec3 for the vector
// itself, or double for its component along one direction.
template <typename T>
struct BernsteinCoefficients {
    std::array<T, 64> of{};
    Vec3 width{1.0};  // of the box

    // The coefficients of ∇D with number `flat`, each entry raised to degree (3, 3, 3).
    std::array<T, 3> gradient(int flat) const {
        return {slope(flat, flat % 4, 1, width.x), slope(flat, flat / 4 % 4, 4, width.y),
                slope(flat, flat / 16, 16, width.z)};
    }

    // The largest measure(difference), over the differences of neighbours along an axis times
    // 3/width. The slopes along the axis are means of these differences. The 16 lines of
    // coefficients are handled at once, so that none waits for another.
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

  private:
    // One entry of ∇D, the derivative along an axis. steps: 1, 4 or 16. position: i, j or k.
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
};

// Space divided at all knots of all lattices, and each piece once more into parts³ boxes. On each
// box the displacement is one polynomial of degree (3, 3, 3). Holds a reference to the fields.
class BernsteinGrid {
  public:
    // sum: at least one field.
    BernsteinGrid(std::span<const LatticeField> sum, int parts);

    IVec3 counts() const {
        return {static_cast<int>(axes_[0].size()), static_cast<int>(axes_[1].size()),
                static_cast<int>(axes_[2].size())};
    }
    Box box(const IVec3& index) const;

    // Computes the coefficients of a box and returns true, or returns false if nothing moves there.
    // part(d): the component of a control point's displacement that is wanted, a T.
    // Cost: about 800 multiplications for each field.
    template <typename T, typename Part>
    bool coefficients(const IVec3& box, const Part& part, BernsteinCoefficients<T>& out) const {
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
    // An interval of one axis that contains no knot, and what each lattice contributes there.
    struct Interval {
        struct Contribution {
            bool is_inside = false;
            int first = 0;  // control point
            CubicSegments conversion{};
        };
        double start = 0.0, width = 0.0;
        std::vector<Contribution> contributions;  // one for each field
    };

    static std::vector<Interval> intervals(std::span<const LatticeField> sum, int axis, int parts);
    const Interval& interval(std::size_t axis, const IVec3& box) const {
        return axes_[axis][static_cast<std::size_t>(box[static_cast<int>(axis)])];
    }

    // Applies a conversion along the axis whose indices are `steps` apart.
    template <typename T>
    static void convert(std::array<T, 64>& values, const CubicSegments& by, std::size_t steps) {
        for (std::size_t line = 0; line < 16; ++line) {
            const std::size_t base = line % steps + line / steps * steps * 4;
            const std::array<T, 4> before{values[base], values[base + steps],
                                          values[base + 2 * steps], values[base + 3 * steps]};
            for (std::size_t k = 0; k < 4; ++k) {
                values[base + k * steps] = by[k][0] * before[0] + by[k][1] * before[1] +
                                           by[k][2] * before[2] + by[k][3] * before[3];
            }
        }
    }

    // Collects the 4 × 4 × 4 control displacements that reach the box. False if all are zero.
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

}  // namespace pectin

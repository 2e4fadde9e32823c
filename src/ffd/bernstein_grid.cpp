#include "ffd/bernstein_grid.h"

#include <cmath>
#include <utility>

namespace pectin {
namespace {

// Knots of two lattices that lie nearer to each other than this fraction of a cell count as one.
// Two cubics that join there with two continuous derivatives differ by the third power of it.
constexpr double kSameKnot = 1e-9;

// All knots of all lattices on an axis, sorted, and the ends of the parts of each gap.
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

}  // namespace

BernsteinGrid::BernsteinGrid(std::span<const LatticeField> sum, int parts)
    : sum_(sum),
      axes_{intervals(sum, 0, parts), intervals(sum, 1, parts), intervals(sum, 2, parts)} {}

Box BernsteinGrid::box(const IVec3& index) const {
    const Interval &x = interval(0, index), &y = interval(1, index), &z = interval(2, index);
    const Vec3 start{x.start, y.start, z.start};
    return {.min = start, .max = start + Vec3{x.width, y.width, z.width}};
}

std::vector<BernsteinGrid::Interval> BernsteinGrid::intervals(std::span<const LatticeField> sum,
                                                              int axis, int parts) {
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
            // Outside, the cell may be beyond the range of int.
            interval.contributions.push_back(
                {.is_inside = is_inside,
                 .first = is_inside ? static_cast<int>(cell) - 1 : 0,
                 .conversion = bernstein_conversion((ends[i] - knot) / lattice.cell[axis],
                                                    (ends[i + 1] - knot) / lattice.cell[axis])});
        }
        result.push_back(std::move(interval));
    }
    return result;
}

}  // namespace pectin

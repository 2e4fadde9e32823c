#include "ffd/lattice.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pectin {
namespace {

// A box that is thinner than this fraction of its longest side counts as flat. Its thickness is
// rounding error, and any drag would take a point out of an influenced zone of that size.
constexpr double kFlatFraction = 1e-6;

bool counts_are_valid(const IVec3& deformable) {
    const auto [least, most] = std::minmax({deformable.x, deformable.y, deformable.z});
    return least >= kMinDeformable && most <= kMaxDeformable;
}

bool margins_are_valid(const Lattice& lattice) {
    const IVec3 counts = lattice.counts();
    for (int axis = 0; axis < 3; ++axis) {
        const int margin = lattice.margin[axis];
        if (margin < 0 || margin > kMaxMargin || counts[axis] < kMinDeformable) return false;
    }
    return true;
}

}  // namespace

bool Lattice::is_valid() const {
    if (!counts_are_valid(deformable) || !margins_are_valid(*this)) return false;
    if (!is_finite(origin) || !is_finite(cell) || !(smallest_cell_extent() > 0.0)) return false;
    const Box zone = influenced_zone();
    return is_finite(zone.min) && is_finite(zone.max);
}

Lattice brush_lattice(const Vec3& centre, double radius, int span) {
    assert(radius > 0.0 && counts_are_valid(IVec3{span}));
    const double half = 0.5 * (span - 1);
    const double cell = radius / (half + 2.0);
    return {.origin = centre - half * cell, .cell = Vec3{cell}, .deformable = IVec3{span}};
}

Lattice fit_lattice(const Box& box, const IVec3& counts) {
    assert(!box.is_empty() && counts_are_valid(counts + 2));
    const Vec3 extent = box.extent();
    const double flat = kFlatFraction * std::max({extent.x, extent.y, extent.z});
    const auto is_flat = [&](int axis) { return extent[axis] <= flat; };

    Lattice lattice{.origin = box.min, .cell = Vec3{0.0}, .deformable = counts};
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (is_flat(axis)) continue;
        const int gaps = counts[axis] == 1 ? 2 : counts[axis] - 1;
        lattice.cell[axis] = extent[axis] / gaps;
        largest = std::max(largest, lattice.cell[axis]);
    }
    if (largest == 0.0) largest = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (is_flat(axis)) lattice.cell[axis] = largest;
        if (!is_flat(axis) && counts[axis] > 1) continue;
        const double half = 0.5 * (counts[axis] - 1);
        lattice.origin[axis] = box.centre()[axis] - half * lattice.cell[axis];
    }
    for (int axis = 0; axis < 3; ++axis) lattice.margin[axis] = counts[axis] == 1 ? 2 : 1;
    lattice.origin -= Vec3{lattice.margin} * lattice.cell;
    lattice.deformable += 2 * lattice.margin;
    return lattice;
}

}  // namespace pectin

// The table of bounds of second derivatives over the eighths of cells, for estimates.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "ffd/derivative_bounds.h"

namespace pectin {
namespace {

// The largest table, and rounding in the parameters of a region, in halves of cells.
constexpr std::size_t kMostTabulated = 1 << 16;
constexpr double kSameHalf = 1e-9;

}  // namespace

void DerivativeBounds::tabulate() {
    if (fields_.size() != 1) return;
    const Lattice& lattice = fields_.front().lattice;
    const IVec3 size = 2 * (lattice.deformable + 3);
    const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                              static_cast<std::size_t>(size.z);
    if (count > kMostTabulated) return;
    std::vector<double> table;
    table.reserve(count);
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const auto corner = [&](const IVec3& half) {
                    return lattice.origin + (0.5 * Vec3{half} - 2.0) * lattice.cell;
                };
                const Vec3 low = corner({i, j, k}), high = corner({i + 1, j + 1, k + 1});
                const Bound of_part = over({{low, high, high}, 0.0}, Vec3{0.0}, Vec3{0.0});
                table.push_back(of_part.bend_any);
            }
        }
    }
    table_ = std::move(table);
    table_size_ = size;
}

double DerivativeBounds::estimate(const std::array<Vec3, 3>& corners) const {
    if (table_.empty()) return everywhere_.second;
    const Lattice& lattice = fields_.front().lattice;
    const auto& [a, b, c] = corners;
    const auto halves = [&](const Vec3& x) { return 2.0 * (lattice.parameter(x) + 2.0); };
    const Vec3 from = halves(glm::min(glm::min(a, b), c)) - kSameHalf,
               to = halves(glm::max(glm::max(a, b), c)) + kSameHalf;
    const Vec3 last{table_size_ - 1};
    if (!glm::all(glm::lessThanEqual(from, last + 1.0)) ||
        !glm::all(glm::greaterThanEqual(to, Vec3{0.0}))) {
        return 0.0;
    }
    const IVec3 low{glm::clamp(from, Vec3{0.0}, last)}, high{glm::clamp(to, Vec3{0.0}, last)};
    double greatest = 0.0;
    for (int k = low.z; k <= high.z; ++k) {
        for (int j = low.y; j <= high.y; ++j) {
            for (int i = low.x; i <= high.x; ++i) {
                const int at = i + table_size_.x * (j + table_size_.y * k);
                greatest = std::max(greatest, table_[static_cast<std::size_t>(at)]);
            }
        }
    }
    return greatest;
}

}  // namespace pectin

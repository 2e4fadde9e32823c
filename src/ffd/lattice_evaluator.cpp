#include "ffd/lattice_evaluator.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace pectin {
namespace {

// Static control points before and after the deformable ones. Of the influenced zone two reach
// inside and the phantom layer is the third; a parameter that rounds up to its border needs one
// more.
constexpr int kBefore = 3, kAfter = 4;

// What the kernels read: everything by value, so that nothing they write can change it.
struct Grid {
    const double* components[3];  // of the control points
    IVec3 stride;                 // of i, j and k
    Vec3 origin, inverse_cell, last_cell;
    Box zone;
};

constexpr std::size_t kBlock = 32;  // points at a time: what stays in the innermost cache
constexpr double kLargest = std::numeric_limits<double>::max();

namespace plain {
#include "ffd/lattice_kernels.inl"
}
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
#include "ffd/lattice_kernels.inl"
}
#pragma GCC pop_options
bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }
#else
namespace avx2 = plain;
bool has_avx2() { return false; }
#endif

}  // namespace

LatticeEvaluator::LatticeEvaluator(const LatticeField& field)
    : lattice_(field.lattice()), zone_(lattice_.influenced_zone()) {
    const IVec3 size = lattice_.deformable + (kBefore + kAfter);
    row_ = size.x;
    layer_ = row_ * size.y;
    for (std::vector<double>* component : {&x_, &y_, &z_}) {
        component->resize(static_cast<std::size_t>(layer_ * size.z));
    }
    for (int k = 0; k < lattice_.deformable.z; ++k) {
        for (int j = 0; j < lattice_.deformable.y; ++j) {
            const std::ptrdiff_t first = kBefore + (j + kBefore) * row_ + (k + kBefore) * layer_;
            for (int i = 0; i < lattice_.deformable.x; ++i) {
                const Vec3& d = field.displacements()[lattice_.control_index({i, j, k})];
                const auto at = static_cast<std::size_t>(first + i);
                x_[at] = d.x;
                y_[at] = d.y;
                z_[at] = d.z;
            }
        }
    }
}

void LatticeEvaluator::displace(std::span<const Vec3> points, std::span<Vec3> to) const {
    assert(to.size() == points.size());
    const auto displace_all = has_avx2() ? avx2::displace_all : plain::displace_all;
    const IVec3 stride{1, static_cast<int>(row_), static_cast<int>(layer_)};
    const Grid grid{{x_.data(), y_.data(), z_.data()}, stride, lattice_.origin, 1.0 / lattice_.cell,
                    Vec3{lattice_.deformable + 3}, zone_};
    displace_all(grid, points.data(), to.data(), points.size());
}

void LatticeEvaluator::transform(std::span<const Vec3> points, std::span<const Vec3f> normals,
                                 std::span<Vec3> to, std::span<Vec3f> turned) const {
    assert(normals.size() == points.size() && to.size() == points.size() &&
           turned.size() == points.size());
    const auto transform_all = has_avx2() ? avx2::transform_all : plain::transform_all;
    const IVec3 stride{1, static_cast<int>(row_), static_cast<int>(layer_)};
    const Grid grid{{x_.data(), y_.data(), z_.data()}, stride, lattice_.origin, 1.0 / lattice_.cell,
                    Vec3{lattice_.deformable + 3}, zone_};
    transform_all(grid, points.data(), normals.data(), to.data(), turned.data(), points.size());
}

std::size_t LatticeEvaluator::memory_bytes() const { return 3 * x_.capacity() * sizeof(double); }

}  // namespace pectin

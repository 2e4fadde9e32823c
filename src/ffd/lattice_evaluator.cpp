#include "ffd/lattice_evaluator.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace pectin {
namespace {

// The numbers of static control points before and after the deformable ones. Two of them reach into
// the influenced zone, and the phantom layer is the third. A parameter that rounds up to the border
// of the zone needs one more.
constexpr int kBefore = 3, kAfter = 4;

// The number of points in a block, chosen so that intermediate results stay in the L1 cache.
constexpr std::size_t kBlock = 32;

constexpr double kLargest = std::numeric_limits<double>::max();

// The input of the kernels. It is passed by value, so that nothing the kernels write can alias it.
struct Grid {
    std::array<const double*, 3> components;  // of the control points
    IVec3 stride;                             // between neighbours in i, j and k
    Vec3 origin, inverse_cell;
    Vec3 last_cell;  // counted from the first of the influenced zone
    Box zone;
};

namespace plain {
#include "ffd/lattice_kernels.inl"
}
#if PECTIN_HAS_WIDE_VERSIONS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
#include "ffd/lattice_kernels.inl"
}
#pragma GCC pop_options
#else
namespace avx2 = plain;
#endif

IVec3 strides(const IVec3& size) { return {1, size.x, size.x * size.y}; }

Grid grid_of(const Lattice& lattice, const IVec3& size,
             const std::array<const double*, 3>& components) {
    return {.components = components,
            .stride = strides(size),
            .origin = lattice.origin,
            .inverse_cell = 1.0 / lattice.cell,
            .last_cell = Vec3{lattice.deformable + (kBefore + kAfter - 4)},
            .zone = lattice.influenced_zone()};
}

}  // namespace

LatticeEvaluator::LatticeEvaluator(const LatticeField& field, Vectors vectors)
    : lattice_(field.lattice()),
      vectors_(vectors),
      size_(lattice_.deformable + (kBefore + kAfter)) {
    const auto count = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                       static_cast<std::size_t>(size_.z);
    for (std::vector<double>* component : {&x_, &y_, &z_}) component->resize(count);
    update(field);
}

void LatticeEvaluator::update(const LatticeField& field) {
    assert(field.lattice() == lattice_);
    const IVec3 stride = strides(size_);
    const Vec3* d = field.displacements().data();
    for (int k = 0; k < lattice_.deformable.z; ++k) {
        for (int j = 0; j < lattice_.deformable.y; ++j) {
            const int first = kBefore + (j + kBefore) * stride.y + (k + kBefore) * stride.z;
            for (int i = 0; i < lattice_.deformable.x; ++i, ++d) {
                const auto at = static_cast<std::size_t>(first + i);
                x_[at] = d->x;
                y_[at] = d->y;
                z_[at] = d->z;
            }
        }
    }
}

void LatticeEvaluator::displace(std::span<const Vec3> points, std::span<Vec3> to) const {
    assert(to.size() == points.size());
    const bool is_wide = vectors_ >= Vectors::avx2;
    const auto displace_all = is_wide ? avx2::displace_all : plain::displace_all;
    displace_all(grid_of(lattice_, size_, {x_.data(), y_.data(), z_.data()}), points.data(),
                 to.data(), points.size());
}

void LatticeEvaluator::transform(std::span<const Vec3> points, std::span<const Vec3f> normals,
                                 std::span<Vec3> to, std::span<Vec3f> transformed) const {
    assert(normals.size() == points.size() && to.size() == points.size() &&
           transformed.size() == points.size());
    const bool is_wide = vectors_ >= Vectors::avx2;
    const auto transform_all = is_wide ? avx2::transform_all : plain::transform_all;
    transform_all(grid_of(lattice_, size_, {x_.data(), y_.data(), z_.data()}), points.data(),
                  normals.data(), to.data(), transformed.data(), points.size());
}

std::size_t LatticeEvaluator::memory_bytes() const { return 3 * x_.capacity() * sizeof(double); }

}  // namespace pectin

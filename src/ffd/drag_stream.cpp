#include "ffd/drag_stream.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace pectin {
namespace {

// A displacement of more than this fraction of a number always changes the number.
constexpr double kSurelyMoves = 2.0 * std::numeric_limits<double>::epsilon();

namespace plain {
constexpr std::size_t kSimdWidth = 4;
#include "ffd/drag_kernels.inl"
}  // namespace plain
#if PECTIN_HAS_WIDE_VERSIONS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
constexpr std::size_t kSimdWidth = 8;
#include "ffd/drag_kernels.inl"
}  // namespace avx2
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f")
namespace avx512 {
constexpr std::size_t kSimdWidth = 16;
#include "ffd/drag_kernels.inl"
}  // namespace avx512
#pragma GCC pop_options
#else
namespace avx2 = plain;
namespace avx512 = plain;
#endif

}  // namespace

bool displace(std::span<const Vec3> rest, std::span<const DragWeight> weights, const Vec3& d,
              std::span<Vec3> to, Vectors vectors) {
    assert(rest.size() == to.size() && weights.size() == to.size());
    const double farthest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const auto moves_all = [&](const auto& displace_all) {
        const auto extremes = displace_all(rest.data(), weights.data(), d, to.data(), to.size());
        return extremes.least_weight * farthest > kSurelyMoves * extremes.greatest_coordinate;
    };
    switch (vectors) {
        case Vectors::avx512:
            return moves_all(avx512::displace_all);
        case Vectors::avx2:
            return moves_all(avx2::displace_all);
        case Vectors::plain:
            break;
    }
    return moves_all(plain::displace_all);
}

void mark_moved(std::span<const Vec3> rest, std::span<const Vec3> to,
                std::span<const std::uint8_t> before, std::span<std::uint8_t> moved) {
    assert(rest.size() == to.size() && before.size() == to.size() && moved.size() == to.size());
    for (std::size_t i = 0; i < to.size(); ++i) moved[i] = before[i] | (rest[i] != to[i] ? 1 : 0);
}

void transform_normals(std::span<const Vec3f> rest, std::span<const DragWeight> weights,
                       const Vec3& d, std::span<Vec3f> to, Vectors vectors) {
    assert(rest.size() == to.size() && weights.size() == to.size());
    const auto transform_all_normals = vectors == Vectors::avx512 ? avx512::transform_all_normals
                                       : vectors == Vectors::avx2 ? avx2::transform_all_normals
                                                                  : plain::transform_all_normals;
    if (d == Vec3{0.0}) {
        std::copy(rest.begin(), rest.end(), to.begin());
    } else {
        transform_all_normals(rest.data(), weights.data(), d, to.data(), to.size());
    }
}

}  // namespace pectin

#include "ffd/drag_stream.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "ffd/vectorised.h"

namespace pectin {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

PECTIN_VECTORISED
void displace_all(const Vec3* __restrict rest, const DragWeight* __restrict weights, Vec3 d,
                  Vec3* __restrict to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double w = static_cast<double>(weights[i].w);
        to[i].x = rest[i].x + w * d.x;
        to[i].y = rest[i].y + w * d.y;
        to[i].z = rest[i].z + w * d.z;
    }
}

PECTIN_VECTORISED
void mark_all(const double* __restrict rest, const double* __restrict to,
              const std::uint8_t* __restrict before, std::uint8_t* __restrict moved,
              std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double* const p = rest + 3 * i;
        const double* const q = to + 3 * i;
        const bool differs = (p[0] != q[0]) | (p[1] != q[1]) | (p[2] != q[2]);
        moved[i] = static_cast<std::uint8_t>(before[i] | static_cast<std::uint8_t>(differs));
    }
}

// Equation 3 for one drag: cof(I + d ∇wᵀ)·n = (1 + ∇w·d) n − (d·n) ∇w. Sums stand in the order in
// which glm::dot forms them; what has no direction becomes zero, what is not bent stays. All arrays
// as plain numbers, three a normal and four a weight, which the compiler sees through.
PECTIN_VECTORISED
void turn_all(const float* __restrict rest, const float* __restrict weights, Vec3 d,
              float* __restrict to, std::size_t count) {
    const double dx = d.x, dy = d.y, dz = d.z;
    for (std::size_t i = 0; i < count; ++i) {
        const float* const n = rest + 3 * i;
        const float* const g = weights + 4 * i + 1;
        const double nx = n[0], ny = n[1], nz = n[2];
        const double gx = g[0], gy = g[1], gz = g[2];
        const double stretch = 1.0 + (gx * dx + gy * dy + gz * dz);
        const double along = dx * nx + dy * ny + dz * nz;
        const double x = stretch * nx - along * gx;
        const double y = stretch * ny - along * gy;
        const double z = stretch * nz - along * gz;
        const double squared = x * x + y * y + z * z;
        // NaN or zero where there is none: the square is beyond numbers, or nothing.
        const double scale = 1.0 / std::sqrt(squared);
        const bool has_direction = squared > 0.0 && squared <= kLargest;
        const bool bends = gx * gx + gy * gy + gz * gz > 0.0;
        const float tx = static_cast<float>(has_direction ? x * scale : 0.0);
        const float ty = static_cast<float>(has_direction ? y * scale : 0.0);
        const float tz = static_cast<float>(has_direction ? z * scale : 0.0);
        to[3 * i] = bends ? tx : n[0];
        to[3 * i + 1] = bends ? ty : n[1];
        to[3 * i + 2] = bends ? tz : n[2];
    }
}

}  // namespace

void displace(std::span<const Vec3> rest, std::span<const DragWeight> weights, const Vec3& d,
              std::span<Vec3> to) {
    assert(rest.size() == to.size() && weights.size() == to.size());
    displace_all(rest.data(), weights.data(), d, to.data(), to.size());
}

void mark_moved(std::span<const Vec3> rest, std::span<const Vec3> to,
                std::span<const std::uint8_t> before, std::span<std::uint8_t> moved) {
    assert(rest.size() == to.size() && before.size() == to.size() && moved.size() == to.size());
    mark_all(&rest.data()->x, &to.data()->x, before.data(), moved.data(), to.size());
}

void turn(std::span<const Vec3f> rest, std::span<const DragWeight> weights, const Vec3& d,
          std::span<Vec3f> to) {
    assert(rest.size() == to.size() && weights.size() == to.size());
    if (d == Vec3{0.0}) {
        std::copy(rest.begin(), rest.end(), to.begin());
    } else {
        turn_all(&rest.data()->x, &weights.data()->w, d, &to.data()->x, to.size());
    }
}

}  // namespace pectin

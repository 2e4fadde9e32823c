// A normal in six bytes.
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/vec.h"
#include "mesh/midpoint_normal.h"

namespace pectin {

// The components are rounded to multiples of 1/32767, so the direction is exact to about 0.002
// degrees. Rounding is the same for x and -x: the packed mirror image is the mirror image of what
// is packed. All zeros stand for an undefined normal.
class PackedNormal {
  public:
    PackedNormal() = default;
    explicit PackedNormal(const Vec3f& n) : x_(packed(n.x)), y_(packed(n.y)), z_(packed(n.z)) {}

    bool is_defined() const { return *this != PackedNormal{}; }
    // Of about unit length, or 0 if it is undefined.
    Vec3f unpacked() const {
        return (1.0f / kScale) *
               Vec3f{static_cast<float>(x_), static_cast<float>(y_), static_cast<float>(z_)};
    }

    bool operator==(const PackedNormal&) const = default;

  private:
    static constexpr float kScale = 32767.0f;

    // Precondition: |x| is at most a few rounding errors above 1.
    static std::int16_t packed(float x) {
        return static_cast<std::int16_t>(kScale * x + std::copysign(0.5f, x));
    }

    std::int16_t x_ = 0, y_ = 0, z_ = 0;
};

// The normalised sum. Undefined if one of the two is, or if they are opposed: see kShortNormalSum.
inline PackedNormal midpoint_normal(const PackedNormal& nb, const PackedNormal& nc) {
    if (!nb.is_defined() || !nc.is_defined()) return {};
    const Vec3f sum = nb.unpacked() + nc.unpacked();
    const float squared = glm::dot(sum, sum);
    if (squared < static_cast<float>(kShortNormalSum * kShortNormalSum)) return {};
    return PackedNormal{sum / std::sqrt(squared)};
}

}  // namespace pectin

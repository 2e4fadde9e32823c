#include "ffd/handle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pectin {
namespace {

constexpr double kDegreesPerStep = 80.0;
// A fraction of 1/n, n steps before the end, is not rounded up to one step more.
constexpr double kStepRounding = 1e-9;

Twist twist_of(const Move& move) {
    return move.twist.value_or(Twist{.axis = {0.0, 0.0, 1.0}, .degrees = 0.0});
}

// Scaled first, since the square of a very long or short axis may leave the range of double.
Vec3 unit_axis(const Vec3& axis) {
    const Vec3 size = glm::abs(axis);
    const double largest = std::max({size.x, size.y, size.z});
    if (!(largest > 0.0) || !is_finite(axis)) return Vec3{0.0};
    return glm::normalize(axis / largest);
}

}  // namespace

bool has_valid_rotation(const Move& move) {
    const Twist twist = twist_of(move);
    return unit_axis(twist.axis) != Vec3{0.0} && std::abs(twist.degrees) <= kMostDegrees &&
           move.scale >= 1.0 / kMostScale && move.scale <= kMostScale;
}

bool rotates(const Move& move) { return twist_of(move).degrees != 0.0 || move.scale != 1.0; }

// The rotation is Rodrigues' formula.
Mat3 jacobian(const Move& move, double fraction) {
    if (!rotates(move)) return Mat3{1.0};
    const Twist twist = twist_of(move);
    const Vec3 k = unit_axis(twist.axis);
    const double angle = fraction * twist.degrees * std::numbers::pi / 180.0;
    const Mat3 cross{0.0, k.z, -k.y, -k.z, 0.0, k.x, k.y, -k.x, 0.0};
    const Mat3 rotation =
        Mat3{1.0} + std::sin(angle) * cross + (1.0 - std::cos(angle)) * (cross * cross);
    return std::pow(move.scale, fraction) * rotation;
}

std::size_t least_steps(const Move& move, double fraction) {
    const double degrees = std::abs(twist_of(move).degrees);
    const double steps = std::ceil(fraction * degrees / kDegreesPerStep - kStepRounding);
    return std::max(std::size_t{1}, static_cast<std::size_t>(steps));
}

}  // namespace pectin

#include "app/up_axis_guess.h"

#include <cmath>

namespace pectin {
namespace {

// A model stands on a plane if its lowest point is nearer to the plane than this part of the box's
// diagonal.
constexpr double kOnPlane = 2e-3;
// It is in the middle of an axis if the middle of its box is nearer to 0 than this part of the
// box's extent along that axis. So a model that stands on y = 0 is not.
constexpr double kInMiddle = 0.2;

}  // namespace

UpAxis guessed_up_axis(const std::optional<UpAxis>& hint, const Box& box) {
    if (hint) return *hint;
    if (box.is_empty()) return UpAxis::y;
    const double tolerance = kOnPlane * box.diagonal();
    const bool stands_on_z = std::abs(box.min.z) <= tolerance && box.max.z > tolerance;
    const bool is_above_middle = std::abs(box.centre().y) <= kInMiddle * box.extent().y;
    return stands_on_z && is_above_middle ? UpAxis::z : UpAxis::y;
}

}  // namespace pectin

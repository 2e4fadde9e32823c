#include "ffd/brush_profile.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <variant>

#include "ffd/drag_solver.h"

namespace pectin {
namespace {

// distance_at() goes in these steps inwards from the border, so that it finds the outermost
// crossing, and then halves the interval.
constexpr int kSteps = 32, kBisections = 18;

DragField unit_field(int span, Falloff falloff) {
    const std::array<Handle, 1> handle{};
    const auto solved = DragSolver::create(brush_lattice(Vec3{0.0}, 1.0, span), handle, {},
                                           std::nullopt, kMaxControlGain, falloff);
    return std::get<DragSolver>(solved).field();
}

}  // namespace

BrushProfile::BrushProfile(int span, Falloff falloff)
    : span_(span), falloff_(falloff), field_(unit_field(span, falloff)) {
    samples_.reserve(static_cast<std::size_t>(kSamples) * kSamples * kSamples);
    constexpr double kStep = 1.0 / (kSamples - 1);
    for (int k = 0; k < kSamples; ++k) {
        for (int j = 0; j < kSamples; ++j) {
            for (int i = 0; i < kSamples; ++i) {
                const double w = std::clamp(weight(kStep * Vec3{IVec3{i, j, k}}), 0.0, 1.0);
                samples_.push_back(static_cast<std::uint8_t>(std::lround(255.0 * w)));
            }
        }
    }
}

double BrushProfile::weight(const Vec3& offset) const {
    std::array<DragField::ExactWeight, 1> weight;
    field_.exact_weights(offset, 0, weight);
    return weight[0].w;
}

double BrushProfile::distance_at(double level, const Vec3& direction) const {
    assert(level > 0.0 && level < 1.0);
    const Vec3 along = glm::abs(direction);
    const double border = 1.0 / std::max({along.x, along.y, along.z});
    const auto is_above = [&](double distance) { return weight(distance * direction) >= level; };
    int step = kSteps - 1;
    while (step > 0 && !is_above(border * step / kSteps)) --step;
    double inside = border * step / kSteps, outside = border * (step + 1) / kSteps;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (inside + outside);
        (is_above(middle) ? inside : outside) = middle;
    }
    return outside;
}

}  // namespace pectin

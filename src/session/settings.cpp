#include "session/settings.h"

#include <algorithm>

#include "geometry/decimal.h"

namespace pectin {
namespace {

double value_or_off(const Setting& s) { return s.kind == Setting::Kind::value ? s.value : kOff; }

double theta_min_of(const AdaptSettings& s) {
    return s.theta_min.is_automatic() ? default_theta_min(value_or_off(s.theta_max))
                                      : value_or_off(s.theta_min);
}

}  // namespace

Result<AdaptSettings> AdaptSettings::with(const command::Adapt& change) const {
    AdaptSettings s = *this;
    s.enabled = change.enabled.value_or(enabled);
    s.trigger = change.trigger.value_or(trigger);
    s.theta_max = change.theta_max.value_or(theta_max);
    s.theta_min = change.theta_min.value_or(theta_min);
    s.tolerance = change.tolerance.value_or(tolerance);
    s.l_max = change.l_max.value_or(l_max);
    s.flatness = change.flatness.value_or(flatness);
    s.floor = change.floor.value_or(floor);
    s.budget = change.budget.value_or(budget);
    s.drag_budget = change.drag_budget.value_or(drag_budget);
    s.propagation = change.propagation.value_or(propagation);
    const double upper = NormalDivergence::angle_or_off(value_or_off(s.theta_max)),
                 lower = theta_min_of(s);
    if (s.theta_min.kind == Setting::Kind::value && upper < kOff && !(lower < upper)) {
        return Refusal{"theta_min (" + decimal(lower) + ") must be less than theta_max (" +
                           decimal(upper) + "); set both, or theta_min to \"auto\"",
                       "theta_min"};
    }
    return s;
}

// The trigger by which conditions (a) are decided.
CurvatureTrigger AdaptSettings::curvature(double diagonal, double largest_coordinate) const {
    using Trigger = command::Adapt::Trigger;
    const double length =
        std::max(tolerance.is_automatic() ? kDefaultToleranceFraction * diagonal : tolerance.value,
                 kLeastToleranceFraction * largest_coordinate);
    if (trigger == Trigger::midpoint) return MidpointDistance(length);
    if (trigger == Trigger::certified) return CertifiedError(length);
    NormalDivergence::Angles angles;
    angles.theta_max = NormalDivergence::angle_or_off(value_or_off(theta_max));
    angles.theta_min = NormalDivergence::angle_or_off(
        theta_min.is_automatic() && angles.theta_max == kOff ? kOff : theta_min_of(*this));
    return NormalDivergence(angles);
}

AdaptLimits AdaptSettings::limits(double feature_extent, double diagonal,
                                  double largest_coordinate) const {
    AdaptLimits limits;
    limits.curvature = curvature(diagonal, largest_coordinate);
    // A certificate needs neither L_max nor the flatness guard.
    const bool is_certified = trigger == command::Adapt::Trigger::certified;
    limits.l_max = !l_max.is_automatic() ? value_or_off(l_max)
                   : is_certified        ? kOff
                                         : default_l_max(feature_extent);
    limits.l_max_is_automatic = l_max.is_automatic();
    const double greatest_angle = NormalDivergence::angle_or_off(value_or_off(theta_max));
    if (!flatness.is_automatic()) {
        limits.flatness = value_or_off(flatness);
    } else if (greatest_angle < kOff && !is_certified) {
        limits.flatness = default_flatness(greatest_angle);
    }
    limits.floor = std::max(floor.is_automatic() ? kDefaultFloorFraction * diagonal : floor.value,
                            kLeastFloorFraction * largest_coordinate);
    limits.propagation = propagation;
    limits.budget = budget;
    return limits;
}

AdaptLimits AdaptSettings::drag_limits(double feature_extent, double diagonal,
                                       double largest_coordinate) const {
    AdaptLimits result = limits(feature_extent, diagonal, largest_coordinate);
    auto* const normals = std::get_if<NormalDivergence>(&result.curvature);
    if (!normals) return result;
    NormalDivergence::RestAllowance allowance = kDefaultRestAllowance;
    // Flatness is then all that keeps the shape of a rough surface. With a theta_min of 0 nothing
    // is decimated.
    if (result.flatness == kOff || !(normals->angles().theta_min > 0.0)) allowance.decimation = 0.0;
    *normals = NormalDivergence(normals->angles(), allowance);
    return result;
}

std::optional<std::uint64_t> AdaptSettings::drag_budget_for(std::uint64_t faces) const {
    if (drag_budget.is_off()) return std::nullopt;
    if (drag_budget.is_automatic()) return default_drag_budget(faces);
    constexpr double kMost = 0x1p53;  // as in scripts
    return static_cast<std::uint64_t>(std::clamp(drag_budget.value, 0.0, kMost));
}

Lattice LatticeSettings::lattice(const Vec3& grabbed, double diagonal) const {
    if (cage) return *cage;
    const double used = radius.value_or(kAutoRadius * diagonal);
    return used > 0.0 ? brush_lattice(grabbed, used, span) : Lattice{.cell = Vec3{0.0}};
}

}  // namespace pectin

#include "session/settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/decimal.h"

namespace pectin {
namespace {

constexpr double kAutoThetaMin = 7.0 / 9.0;  // times theta_max: the paper uses pi/7 and pi/9
constexpr double kAutoFloor = 1e-4;          // times the box diagonal
// The least floor as a fraction of the largest coordinate: 2^10 units in the last place. Rounding
// then hardly changes the halves of an edge.
constexpr double kLeastFloor = 0x1p-42;

double value_or_off(const Setting& s) { return s.kind == Setting::Kind::value ? s.value : kOff; }

double theta_min_of(const AdaptSettings& s) {
    const double theta_max = value_or_off(s.theta_max);
    return s.theta_min.is_automatic() ? kAutoThetaMin * theta_max : value_or_off(s.theta_min);
}

// An angle of 180 degrees or more disables its test.
double angle_or_off(double degrees) { return degrees < 180.0 ? degrees : kOff; }

}  // namespace

std::variant<AdaptSettings, std::string> AdaptSettings::with(const command::Adapt& change) const {
    AdaptSettings s = *this;
    s.enabled = change.enabled.value_or(enabled);
    s.theta_max = change.theta_max.value_or(theta_max);
    s.theta_min = change.theta_min.value_or(theta_min);
    s.l_max = change.l_max.value_or(l_max);
    s.flatness = change.flatness.value_or(flatness);
    s.floor = change.floor.value_or(floor);
    s.budget = change.budget.value_or(budget);
    s.propagation = change.propagation.value_or(propagation);
    const double upper = angle_or_off(value_or_off(s.theta_max)), lower = theta_min_of(s);
    if (s.theta_min.kind == Setting::Kind::value && upper < kOff && !(lower < upper)) {
        return "theta_min (" + decimal(lower) + ") must be less than theta_max (" + decimal(upper) +
               "); set both, or theta_min to \"auto\"";
    }
    return s;
}

AdaptLimits AdaptSettings::limits(double feature_extent, double diagonal,
                                  double largest_coordinate) const {
    AdaptLimits limits;
    limits.theta_max = angle_or_off(value_or_off(theta_max));
    limits.theta_min = angle_or_off(
        theta_min.is_automatic() && limits.theta_max == kOff ? kOff : theta_min_of(*this));
    limits.l_max = l_max.is_automatic() ? feature_extent : value_or_off(l_max);
    if (!flatness.is_automatic()) {
        limits.flatness = value_or_off(flatness);
    } else if (limits.theta_max < kOff) {
        // The sagitta of an arc over an angle of theta_max, in units of its chord.
        limits.flatness = 0.5 * std::tan(limits.theta_max / 4.0 * std::numbers::pi / 180.0);
    }
    limits.floor = std::max(floor.is_automatic() ? kAutoFloor * diagonal : floor.value,
                            kLeastFloor * largest_coordinate);
    limits.propagation = propagation;
    limits.budget = budget;
    return limits;
}

Lattice LatticeSettings::lattice(const Vec3& grabbed, double diagonal) const {
    if (cage) return *cage;
    const double used = radius.value_or(kAutoRadius * diagonal);
    return used > 0.0 ? brush_lattice(grabbed, used, span) : Lattice{.cell = Vec3{0.0}};
}

}  // namespace pectin

// The settings that commands change and drags use, and their values for a given object.
#pragma once

#include <cstdint>
#include <optional>

#include "adapt/criteria.h"
#include "adapt/defaults.h"
#include "command/command.h"
#include "command/result.h"
#include "ffd/lattice.h"
#include "geometry/falloff.h"

namespace pectin {

struct AdaptSettings {
    bool enabled = true;
    command::Adapt::Trigger trigger = command::Adapt::Trigger::normals;
    Setting theta_max = Setting::of(kDefaultThetaMax);  // degrees
    Setting theta_min = Setting::automatic();
    Setting tolerance = Setting::automatic();
    Setting l_max = Setting::automatic();
    Setting flatness = Setting::automatic();
    Setting floor = Setting::automatic();
    std::uint64_t budget = 4'000'000;            // triangles of the object
    Setting drag_budget = Setting::automatic();  // triangles that a drag may add
    double propagation = 1.0;

    bool operator==(const AdaptSettings&) const = default;
    // Returns these settings with the changes of the command, or the reason why they contradict
    // each other.
    Result<AdaptSettings> with(const command::Adapt& change) const;
    // The limits in world units, for a command that applies them to the object as it is (readapt).
    // feature_extent: the smallest feature extent of the deformation, or kOff if there is none.
    // diagonal, largest_coordinate: of the object's box when it was opened. Floor and tolerance are
    // well above what coordinates of that size resolve.
    AdaptLimits limits(double feature_extent, double diagonal,
                       double largest_coordinate = 0.0) const;
    // The same for a drag, which leaves roughness alone that it has not made.
    AdaptLimits drag_limits(double feature_extent, double diagonal,
                            double largest_coordinate = 0.0) const;
    // In triangles, for a drag that moves so many faces; nothing if there is no limit.
    std::optional<std::uint64_t> drag_budget_for(std::uint64_t faces) const;

  private:
    CurvatureTrigger curvature(double diagonal, double largest_coordinate) const;
};

inline constexpr double kAutoRadius = 0.25;  // of a brush, as a fraction of the box diagonal

// The lattice that a drag gets.
struct LatticeSettings {
    std::optional<double> radius;      // of the brush; by default a quarter of the box diagonal
    int span = 3;                      // of the brush
    Falloff falloff = Falloff::sharp;  // of the brush; drags in a cage are sharp
    std::optional<Lattice> cage;       // used instead of the brush if it is set

    // The lattice of a drag whose first handle is `grabbed`. It is not valid if the object has no
    // extent from which the radius of the brush could follow.
    Lattice lattice(const Vec3& grabbed, double diagonal) const;
};

}  // namespace pectin

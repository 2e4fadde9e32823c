// The settings that commands change and drags use, and what they come to for a given object.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "adapt/criteria.h"
#include "adapt/defaults.h"
#include "command/command.h"
#include "ffd/lattice.h"

namespace pectin {

struct AdaptSettings {
    bool enabled = true;
    Setting theta_max = Setting::of(kDefaultThetaMax);  // degrees
    Setting theta_min = Setting::automatic();
    Setting l_max = Setting::automatic();
    Setting flatness = Setting::automatic();
    Setting floor = Setting::automatic();
    std::uint64_t budget = 4'000'000;  // triangles
    double propagation = 1.0;

    // The settings with the command's given ones, or why they do not go together.
    std::variant<AdaptSettings, std::string> with(const command::Adapt& change) const;
    // smallest_cell: of the lattice in use, kOff if there is none. diagonal and largest coordinate:
    // of the object's box as it was opened. The floor stays well above what coordinates resolve.
    AdaptLimits limits(double smallest_cell, double diagonal,
                       double largest_coordinate = 0.0) const;
};

inline constexpr double kAutoRadius = 0.25;  // of a brush, of the box diagonal

// Which lattice a drag gets.
struct LatticeSettings {
    std::optional<double> radius;  // brush; none: a quarter of the box diagonal
    int span = 3;                  // brush
    std::optional<Lattice> cage;   // in use instead of the brush, if set

    // For a drag whose first moved point is `grabbed`. Not valid where an object without extent
    // gives the brush no radius.
    Lattice lattice(const Vec3& grabbed, double diagonal) const;
};

}  // namespace pectin

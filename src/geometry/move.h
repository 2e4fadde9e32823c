// The movement of one handle of a drag, as the user asks for it.
#pragma once

#include <optional>

#include "geometry/vec.h"

namespace pectin {

// A rotation of the surroundings of a handle about an axis through it.
struct Twist {
    Vec3 axis{0.0};        // of any length above 0
    double degrees = 0.0;  // by the right-hand rule
    bool operator==(const Twist&) const = default;
};

// A point of the surface and where it goes, in world space. Tools, commands, the session and the
// planner of a drag all use this type. ffd/handle.h derives from it what one step of a drag does.
struct Move {
    Vec3 from{0.0}, to{0.0};
    std::optional<Twist> twist{};
    double scale = 1.0;  // of the surroundings
    bool operator==(const Move&) const = default;
};

}  // namespace pectin

// A rectangle on the screen.
#pragma once

#include "geometry/vec.h"

namespace pectin {

// In window coordinates. The corners may be in any order.
struct ScreenBox {
    Vec2 from{0.0}, to{0.0};
};

}  // namespace pectin

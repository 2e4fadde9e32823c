// Repetition of the last drag at another point.
#pragma once

#include <optional>

#include "app/tool_context.h"

namespace pectin {

// Returns the last drag, moved to the point under the cursor and rotated as the normal of the
// surface there differs from that where the drag began: what was pulled outwards is pulled outwards
// again. Directions within the surface turn as little as possible. Pins and options are the present
// ones. With symmetry the drag stays on its side of the plane. Returns nothing if there is no last
// drag or no surface under the cursor, and with a cage. If the radius is measured on the screen,
// the session gets the radius of that point. Precondition: no work in the background.
std::optional<command::Drag> repeated_drag(ToolContext& context);

}  // namespace pectin

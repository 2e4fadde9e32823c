// The rings that show how far a drag reaches.
#pragma once

#include "app/tool_context.h"
#include "render/overlay.h"

namespace pectin {

// Adds two rings in the tangent plane of the point under the cursor, and with symmetry also their
// images: an outer one, beyond which nothing moves, and an inner one, where everything moves half
// as far as the point. Both are as far away in each direction as the lattice of the brush makes
// them, so they are not quite round. Adds nothing where a drag would not use the brush.
void add_brush_rings(Overlay& overlay, const ToolContext& context, const Colour& colour);

// The same for an active drag with this normal of the surface, where its last step began. Points of
// the inner ring have moved half as far as the dragged point, which is at `to` now.
void add_drag_rings(Overlay& overlay, const ToolContext& context, const Vec3& normal,
                    const Vec3& to, const Colour& colour);

}  // namespace pectin

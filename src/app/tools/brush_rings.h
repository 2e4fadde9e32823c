// The circle that shows the radius of the brush at the cursor.
#pragma once

#include "app/tool_context.h"
#include "render/overlay.h"

namespace pectin {

// Adds the circle in the tangent plane of the point under the cursor, and with symmetry also its
// image. Adds nothing where a drag would not use the brush.
void add_brush_circle(Overlay& overlay, const ToolContext& context, const Colour& colour);

}  // namespace pectin

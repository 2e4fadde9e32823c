// A picture of how the motion of a drag falls off around the grabbed point.
#pragma once

#include "ffd/brush_profile.h"

namespace pectin {

// Draws the weight along an axis of the brush's lattice, from a radius on one side of the grabbed
// point to a radius on the other, with lines where it is half. It fills the row and has a tooltip.
// Precondition: a window of Dear ImGui is being laid out.
void draw_falloff_curve(const BrushProfile& profile);

}  // namespace pectin

// How the displacement of a drag decreases around a dragged point.
#pragma once

namespace pectin {

enum class Falloff {
    sharp,   // the smallest displacement of the control points: a peak at the point
    plateau  // the control points around the point move together, as far as the point itself
};

}  // namespace pectin

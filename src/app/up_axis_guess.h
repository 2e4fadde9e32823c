// Guesses which axis of a model points upwards.
#pragma once

#include <optional>

#include "geometry/box.h"
#include "geometry/up_axis.h"

namespace pectin {

// hint: what the model's file says (ReadReport::up_axis); it decides. Without one, a model that
// stands on the plane z = 0 with its middle above y = 0 has z up; all others have y up, which is
// the convention of OBJ files.
UpAxis guessed_up_axis(const std::optional<UpAxis>& hint, const Box& box);

}  // namespace pectin

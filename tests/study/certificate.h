// The time of the bound that the certified trigger asks for each face.
#pragma once

#include "study/scene.h"
#include "study/studies.h"

namespace pectin::study {

// Nanoseconds for each face of the scene: rows of {what, ns}. None if this version of the program
// has no such bound.
Json certificate_times(const Scene& scene, int repetitions);

}  // namespace pectin::study

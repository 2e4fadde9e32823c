// Passed faces: parts of the surface that a gesture leaves alone and that the part it moves passes
// through. That is no sampling error as self-intersections are, and it is only reported.
#pragma once

#include <span>
#include <vector>

#include "geometry/stop_token.h"
#include "mesh/active_set.h"

namespace pectin {

// Faces that stay where they are and intersect faces that have moved.
struct PassedFaces {
    std::vector<FaceId> faces;  // sorted
    bool are_all = true;        // false if the search ended before it had tested all pairs
};

// Finds those of `others`, and of the faces that splits have made of them, that intersect an active
// face which has moved, and were disjoint from it at rest. The others were outside the active set
// when the gesture began. Faces that share a corner do not count.
//
// stop: asked after each few thousand pairs; Stopped is thrown where it asks for it.
//
// Cost: O(1) if there are no others. Otherwise O(k log k + p) for k other and active faces and p
// pairs of near faces, and one word per face slot.
PassedFaces find_passed_faces(const ActiveSet& active, std::span<const FaceId> others,
                              const StopToken& stop = {});

}  // namespace pectin

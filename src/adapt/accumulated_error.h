// What a gesture adds to the errors of faces, at its end.
#pragma once

#include <optional>

#include "adapt/criteria.h"
#include "mesh/active_set.h"

namespace pectin {

// Sets TriMesh::error() of all active faces to what it is after the gesture, if the certified
// trigger is in use, and returns the largest bound of what this gesture has added; none otherwise.
// Precondition: the mesh tracked errors when the gesture began, and is adapted. Throws
// std::bad_alloc before anything changes. Cost: one bound for each active face, and another one for
// each with an error.
std::optional<double> accumulate_errors(ActiveSet& active, const Criteria& criteria);

// The largest error of a face. Cost: O(faces).
double largest_error(const TriMesh& mesh);

}  // namespace pectin

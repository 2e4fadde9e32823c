// The pass of a frame over an active set where one drag acts: positions and normals.
#pragma once

#include <span>

#include "ffd/drag_field.h"
#include "mesh/active_set.h"

namespace pectin {

// All of an active set, from where the drag finds it. starts, weights: of all vertex entries;
// normals: of all wedge entries. Removed elements and those that are not influenced stay as they
// are. On all threads; the same as displaced() and covariant_normal() entry by entry, to the bit.
// Vertices and wedges go block by block in turn: where they lie alike, as they do on a smooth
// surface, weights are read from memory once. Cost: O(entries), streaming where ids and entries run
// alike.
void deform(ActiveSet& active, std::span<const Vec3> starts, std::span<const Vec3f> normals,
            std::span<const DragWeight> weights, const Vec3& d);

}  // namespace pectin

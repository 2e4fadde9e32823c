// The pass of a frame over an active set where one drag acts: positions and normals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ffd/drag_field.h"
#include "mesh/active_set.h"

namespace pectin {

// For each block of a pass which of its elements have ids that run on and always will, until the
// gesture ends: a frame need not look at them. To be asked before the first edit.
// Cost: O(influenced).
std::vector<std::uint8_t> lasting_runs(const ActiveSet& active);

// All of an active set, from where the drag finds it. starts, weights: of all vertex entries;
// normals: of all wedge entries. Removed elements and those that are not influenced stay as they
// are. On all threads; the same as displaced() and covariant_normal() entry by entry, to the bit.
// Vertices and wedges go block by block in turn: where they lie alike, as they do on a smooth
// surface, weights are read from memory once. Cost: O(entries), streaming where ids and entries run
// alike.
// runs: lasting_runs of the active set when the gesture began, or nothing.
void deform(ActiveSet& active, std::span<const Vec3> starts, std::span<const Vec3f> normals,
            std::span<const DragWeight> weights, std::span<const std::uint8_t> runs, const Vec3& d);

}  // namespace pectin

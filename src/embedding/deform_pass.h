// The pass of a frame over an active set that one drag deforms: positions and normals.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Sections 2 and 3.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ffd/drag_field.h"
#include "mesh/active_set.h"

namespace pectin {

// For each block of entries, which of its elements have consecutive ids and keep them until the
// gesture ends, so that frames need not check. Precondition: nothing has been edited in this
// gesture. Cost: O(influenced entries).
std::vector<std::uint8_t> lasting_runs(const ActiveSet& active);

// Deforms all influenced elements of an active set by the displacement d of one drag, on all
// threads. Removed elements and those that are not influenced keep their values.
//
// starts: positions of all vertex entries before the drag. normals: of all wedge entries before the
// drag. weights: of all vertex entries. runs: the lasting_runs of the active set, or empty.
//
// The result is bit for bit what displaced() and covariant_normal() give for each entry. Vertices
// and wedges take turns block by block: on a smooth surface, where their entries correspond,
// weights are read from memory once. Cost: O(entries), streaming where ids and entries run alike.
void deform(ActiveSet& active, std::span<const Vec3> starts, std::span<const Vec3f> normals,
            std::span<const DragWeight> weights, std::span<const std::uint8_t> runs, const Vec3& d);

}  // namespace pectin

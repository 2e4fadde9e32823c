// The passes of a frame over an active set where one drag acts: positions, then normals.
#pragma once

#include <cstdint>
#include <span>

#include "ffd/drag_field.h"
#include "mesh/active_set.h"

namespace pectin {

// Entries [first, end) of the active set from where the drag finds them. starts, weights: of all
// vertex entries. Removed vertices and those that are not influenced stay as they are. On all
// threads; the same as displaced() and covariant_normal() entry by entry, to the bit.
// Cost: O(end - first), streaming where ids and entries run alike.
void deform_vertices(ActiveSet& active, std::span<const Vec3> starts,
                     std::span<const DragWeight> weights, const Vec3& d, std::uint32_t first,
                     std::uint32_t end);

// starts: of all wedge entries; weights: of all vertex entries.
void deform_wedges(ActiveSet& active, std::span<const Vec3f> starts,
                   std::span<const DragWeight> weights, const Vec3& d, std::uint32_t first,
                   std::uint32_t end);

}  // namespace pectin

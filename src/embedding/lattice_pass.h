// The passes of a frame over an active set where control points were moved by hand.
// Source: Gain & Dodgson 1999, equations 1–7.
#pragma once

#include <cstdint>
#include <span>

#include "ffd/lattice_evaluator.h"
#include "mesh/active_set.h"

namespace pectin {

// All of it from where the field finds it: positions, deformed marks and wedge normals, together
// where entries of vertices and wedges run alike. starts: of all vertex entries; normals: of all
// wedge entries. Removed elements and those that are not influenced stay as they are. On all
// threads; the same bits as the two functions below. Cost: O(entries).
void deform(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
            std::span<const Vec3f> normals);

// Vertex entries [first, end).
void deform_vertices(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
                     std::uint32_t first, std::uint32_t end);

// Wedge entries [first, end).
void deform_wedges(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
                   std::span<const Vec3f> normals, std::uint32_t first, std::uint32_t end);

}  // namespace pectin

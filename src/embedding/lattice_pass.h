// The passes of a frame over an active set that a field of control points deforms.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Equations 1 and 3 to 7.
#pragma once

#include <cstdint>
#include <span>

#include "ffd/lattice_evaluator.h"
#include "mesh/active_set.h"

namespace pectin {

// Sets the positions, deformed marks and wedge normals of all influenced elements of an active set,
// on all threads. Removed elements and those that are not influenced keep their values.
//
// starts: positions of all vertex entries before this step. normals: of all wedge entries before
// this step. Vertices and wedges whose entries correspond are evaluated together; the result is bit
// for bit that of the two functions below. Cost: O(entries).
void deform(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
            std::span<const Vec3f> normals);

// The positions and deformed marks of the vertex entries [first, end).
void deform_vertices(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
                     std::uint32_t first, std::uint32_t end);

// The normals of the wedge entries [first, end).
void deform_wedges(ActiveSet& active, const LatticeEvaluator& field, std::span<const Vec3> starts,
                   std::span<const Vec3f> normals, std::uint32_t first, std::uint32_t end);

}  // namespace pectin

// A frame of a gesture with one weight, as streaming passes over flat arrays. The results equal
// those of displaced() and covariant_normal() in ffd/drag_weight.h bit for bit, for each
// instruction set. Precondition: the machine has the instruction set.
#pragma once

#include <cstdint>
#include <span>

#include "ffd/drag_field.h"
#include "ffd/vectorised.h"

namespace pectin {

// Writes the displaced points. rest, weights, to: n_points, in world space; `to` must not overlap
// the others. Returns true if every point has certainly moved, in the coordinate in which d is
// longest. Otherwise mark_moved() finds out which have moved.
bool displace(std::span<const Vec3> rest, std::span<const DragWeight> weights, const Vec3& d,
              std::span<Vec3> to, Vectors vectors = widest_vectors());

// Sets moved to 1 where `to` differs from `rest` or `before` is 1, and else to 0. All n_points.
void mark_moved(std::span<const Vec3> rest, std::span<const Vec3> to,
                std::span<const std::uint8_t> before, std::span<std::uint8_t> moved);

// Writes the transformed normals, of unit length or zero. rest, weights (of the vertex of each
// normal), to: n_normals; `to` must not overlap the others.
void transform_normals(std::span<const Vec3f> rest, std::span<const DragWeight> weights,
                       const Vec3& d, std::span<Vec3f> to, Vectors vectors = widest_vectors());

}  // namespace pectin

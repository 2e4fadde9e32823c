// A frame of a gesture with one drag, as streaming passes over flat arrays.
// Source: as drag_field.h; displaced() and covariant_normal() give the same to the bit, whatever
// the vectors, which may be any up to the widest that the machine has.
#pragma once

#include <cstdint>
#include <span>

#include "ffd/drag_field.h"
#include "ffd/vectorised.h"

namespace pectin {

// rest, weights, to: n_points, `to` apart from the others. World space. Whether all have moved for
// sure, each in the direction in which d is longest; if not, mark_moved tells which have.
bool displace(std::span<const Vec3> rest, std::span<const DragWeight> weights, const Vec3& d,
              std::span<Vec3> to, Vectors vectors = widest_vectors());

// moved: 1 where `to` differs from `rest` or `before` is 1, else 0. All n_points.
void mark_moved(std::span<const Vec3> rest, std::span<const Vec3> to,
                std::span<const std::uint8_t> before, std::span<std::uint8_t> moved);

// rest, weights (of the vertex of each), to: n_normals, `to` apart from the others. Unit or zero.
void transform_normals(std::span<const Vec3f> rest, std::span<const DragWeight> weights,
                       const Vec3& d, std::span<Vec3f> to, Vectors vectors = widest_vectors());

}  // namespace pectin
